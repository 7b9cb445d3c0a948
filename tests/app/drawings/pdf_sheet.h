// A page of PDF in writing, and what is painted on it. Millimetres of the sheet, y downwards.
// Threads: one sheet, one thread.
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
    /// Its size, boxes, turn and unit are chosen at random.
    explicit PdfSheet(Chance& chance);

    /// Written with joins, caps and units of length by chance; broad strokes are round.
    void paint(const Paint& paint);

    /// Written in units that become the sheet's by this map; it may make the pen uneven, whose
    /// width is that of its broad side.
    void paint(const Paint& paint, const Matrix& units);

    /// The operators that paint it so.
    [[nodiscard]] std::string operators_of(const Paint& paint, const Matrix& units = {});

    /// Painted by operators that were written otherwise.
    void know(const Paint& paint) { paints_.push_back(paint); }

    void write(std::string_view operators) { content_ += operators; }

    /// Words from here on, turned; grey from black (0) to white (1).
    void say(std::string_view words, const cv::Point2d& at, double size_mm, double turn_deg = 0.0,
             double grey = 0.0);

    /// How it is asked for: "7 0 R".
    [[nodiscard]] std::string add_object(const std::string& body);

    /// A resource of a category as "/Pattern", its name: "/R3".
    [[nodiscard]] std::string add_resource(const std::string& category, const std::string& value);

    /// What patterns are written in, by this map.
    [[nodiscard]] Matrix units_of_patterns() const;

    /// Without kind and name.
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
    bool is_form_ = false;  // all of it in one form
    Matrix to_page_;        // from the sheet
    std::string content_;
    std::vector<std::string> objects_;
    std::map<std::string, std::string> resources_;  // of each category
    int resource_count_ = 0;
    std::vector<Paint> paints_;
};

/// Six numbers as PDF has them.
[[nodiscard]] std::string written(const Matrix& matrix);

}  // namespace touchline::testing
