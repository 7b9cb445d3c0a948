// Draws test pictures with Cairo, as a vector program would: anti-aliased.
// Threads: one canvas, one thread.
#pragma once

#include "config/types/pinned.h"

#include <string>
#include <vector>

#include <cairo.h>
#include <opencv2/core.hpp>

namespace touchline::testing {

/// Points in picture pixels, as Cairo counts them: (0, 0) is the corner of the first pixel.
struct Polyline {
    std::vector<cv::Point2d> points;
    bool is_closed = false;
};

enum class Join { round, mitre, bevel };
enum class Cap { round, butt, square };

/// A pen as in drawing programs; draws mitres down to angles of 6 degrees.
struct Pen {
    double width_px = 1.0;
    Join join = Join::round;
    Cap cap = Cap::round;
};

struct Font {
    std::string family = "DejaVu Sans";
    double size_px = 20.0;
    bool is_bold = false;
    bool is_italic = false;
};

class Canvas : Pinned {
  public:
    /// Begins with bare paper. Colours are BGR, 0..255, as everywhere in OpenCV.
    Canvas(cv::Size size, const cv::Scalar& paper);
    ~Canvas();

    /// Fills all rings together by the even-odd rule.
    void fill(const std::vector<Polyline>& rings, const cv::Scalar& ink);

    void stroke(const std::vector<Polyline>& lines, const Pen& pen, const cv::Scalar& ink);

    /// Draws with round joins and caps.
    void stroke(const std::vector<Polyline>& lines, double width_px, const cv::Scalar& ink) {
        stroke(lines, Pen{width_px}, ink);
    }

    /// Starts the baseline at `at`.
    void write(const std::string& text, cv::Point2d at, const Font& font, const cv::Scalar& ink);

    /// Returns the outline of one text as Cairo flattens it, with the baseline at `at`.
    [[nodiscard]] std::vector<Polyline> outline_of(const std::string& text, cv::Point2d at,
                                                   const Font& font);

    [[nodiscard]] double width_of(const std::string& text, const Font& font);

    /// Returns 8-bit BGR.
    [[nodiscard]] cv::Mat picture() const;

  private:
    void add(const std::vector<Polyline>& lines);
    void use(const Font& font);
    void use(const cv::Scalar& ink);

    cv::Size size_;
    cairo_surface_t* surface_;
    cairo_t* pen_;
};

/// Returns a part of an ellipse, in degrees from the x axis towards y; closed if it goes all the
/// way round.
[[nodiscard]] Polyline arc(cv::Point2d centre, cv::Size2d radii, double from_deg = 0.0,
                           double to_deg = 360.0);

/// Returns `line` turned about the origin, then scaled, then moved.
[[nodiscard]] Polyline placed(const Polyline& line, cv::Point2d at, double scale, double angle_deg);

}  // namespace touchline::testing
