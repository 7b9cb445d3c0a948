// Writes a PDF page and records what is painted on it. Lengths are millimetres of the sheet, y
// downwards. Threads: one sheet, one thread.
#pragma once

#include "tests/app/drawings/matrix.h"
#include "tests/app/drawings/paint.h"
#include "tests/vision/pictures/chance.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace touchline::testing {

class PdfSheet {
  public:
    /// Chooses size, boxes, turn and unit at random.
    explicit PdfSheet(Chance& chance);

    /// Paints with random joins, caps and units of length; broad strokes are round.
    void paint(const Paint& paint);

    /// Paints in units that this map turns into the sheet's. It may make the pen uneven; the pen's
    /// width is then that of its broad side.
    void paint(const Paint& paint, const Matrix& units);

    /// Returns the operators that paint this.
    [[nodiscard]] std::string operators_of(const Paint& paint, const Matrix& units = {});

    /// Records what operators written elsewhere paint.
    void know(const Paint& paint) { paints_.push_back(paint); }

    void write(std::string_view operators) { content_ += operators; }

    /// Writes words from here on, turned; grey from black (0) to white (1).
    void say(std::string_view words, const cv::Point2d& at, double size_mm, double turn_deg = 0.0,
             double grey = 0.0);

    /// Adds an object and returns its reference: "7 0 R".
    [[nodiscard]] std::string add_object(const std::string& body);

    /// Adds a resource to a category such as "/Pattern" and returns its name: "/R3".
    [[nodiscard]] std::string add_resource(const std::string& category, const std::string& value);

    /// Returns the map of the units that patterns are written in.
    [[nodiscard]] Matrix units_of_patterns() const;

    /// Returns the drawing, without kind and name.
    [[nodiscard]] Drawing drawing();

  private:
    [[nodiscard]] cv::Size2d size_pt() const;
    [[nodiscard]] std::string boxes() const;

    Chance& chance_;
    double pt_per_mm_ = 5.0;
    double user_unit_ = 1.0;
    int quarter_turns_ = 0;
    cv::Point2d corner_pt_;
    bool is_cropped_ = false;
    bool is_form_ = false;  // everything is in one form XObject
    Matrix to_page_;        // from the sheet
    std::string content_;
    std::vector<std::string> objects_;
    std::map<std::string, std::string> resources_;  // by category
    int resource_count_ = 0;
    std::vector<Paint> paints_;
};

/// Writes six numbers as PDF does.
[[nodiscard]] std::string written(const Matrix& matrix);

}  // namespace touchline::testing
