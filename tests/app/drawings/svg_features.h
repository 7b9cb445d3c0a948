// The features of SVG that drawings are made around, grouped by what they change.
// Threads: pure functions of the chance.
#pragma once

#include "tests/app/drawings/paint.h"
#include "tests/vision/pictures/chance.h"

#include <span>
#include <string>
#include <string_view>

namespace touchline::testing {

struct SvgFeature {
    std::string_view name;
    Drawing (*draw)(Chance&);  // draws without kind and name
};

/// Returns fills, strokes, colours and what is painted over.
[[nodiscard]] std::span<const SvgFeature> svg_paint_features();

/// Returns sizes, units, transforms, clips, masks and reuse.
[[nodiscard]] std::span<const SvgFeature> svg_place_features();

/// Returns an SVG of the sheet's size around `body`.
[[nodiscard]] std::string svg_sheet(std::string_view body);

inline const cv::Point2d left_half_mm(30.0, 42.0);
inline const cv::Point2d right_half_mm(86.0, 42.0);

/// One of eight dark colours.
struct Ink {
    cv::Scalar bgr;
    std::string css;  // in one of several notations
};

[[nodiscard]] Ink any_ink(Chance& chance);

[[nodiscard]] Paint filled(const Polyline& line, const cv::Scalar& bgr);
[[nodiscard]] Paint stroked(const Polyline& line, double width_mm, const cv::Scalar& bgr);

/// Returns a pen's width: 0.4 ... 2.6 mm.
[[nodiscard]] double pen_mm(Chance& chance);

}  // namespace touchline::testing
