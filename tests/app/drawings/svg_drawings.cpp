#include "tests/app/drawings/svg_drawings.h"

#include "tests/app/drawings/svg_features.h"

#include <array>

#include <fmt/format.h>

namespace touchline::testing {

std::string svg_sheet(std::string_view body) {
    return fmt::format(R"(<?xml version="1.0" encoding="UTF-8"?><svg )"
                       R"(xmlns="http://www.w3.org/2000/svg" )"
                       R"(xmlns:xlink="http://www.w3.org/1999/xlink" )"
                       R"(width="116mm" height="84mm" viewBox="0 0 116 84">{}</svg>)",
                       body);
}

Ink any_ink(Chance& chance) {
    constexpr std::array<std::array<int, 3>, 8> inks{{{0, 0, 0},
                                                      {128, 0, 0},
                                                      {0, 100, 0},
                                                      {0, 0, 128},
                                                      {96, 64, 16},
                                                      {70, 20, 90},
                                                      {0, 80, 90},
                                                      {60, 60, 60}}};
    const auto [r, g, b] = inks[static_cast<std::size_t>(chance.below(8))];
    const std::array<std::string, 3> ways{
        fmt::format("#{:02x}{:02x}{:02x}", r, g, b), fmt::format("rgb({},{},{})", r, g, b),
        fmt::format("rgb({:.3f}%, {:.3f}%, {:.3f}%)", r / 2.55, g / 2.55, b / 2.55)};
    return {cv::Scalar(b, g, r), ways[static_cast<std::size_t>(chance.below(3))]};
}

Paint filled(const Polyline& line, const cv::Scalar& bgr) {
    Paint paint{{line}};
    paint.colour = bgr;
    return paint;
}

Paint stroked(const Polyline& line, double width_mm, const cv::Scalar& bgr) {
    Paint paint{{line}, width_mm};
    paint.colour = bgr;
    return paint;
}

double pen_mm(Chance& chance) {
    return chance.between(0.4, 2.6);
}

int svg_feature_count() {
    return static_cast<int>(svg_paint_features().size() + svg_place_features().size());
}

Drawing svg_drawing(int feature, int seed) {
    const auto index = static_cast<std::size_t>(feature);
    const std::size_t paints = svg_paint_features().size();
    const SvgFeature& one =
        index < paints ? svg_paint_features()[index] : svg_place_features()[index - paints];
    Chance chance(1000 * feature + seed);
    Drawing drawing = one.draw(chance);
    drawing.kind = one.name;
    drawing.name = fmt::format("{} {}", one.name, seed);
    return drawing;
}

}  // namespace touchline::testing
