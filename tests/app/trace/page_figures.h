// Pages as a drawing program writes them to PDF, with the lines that can be seen on them, by the
// geometry of what was drawn. Threads: pure functions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace touchline::testing {

struct PagePoint {
    double x = 0.0;  // points from the left
    double y = 0.0;  // points from the top
};

/// A line that is to be seen: the middle of a stroke, or the border of an area.
struct VisibleLine {
    std::vector<PagePoint> points;
    std::string kind;  // of the figure that it belongs to
    int figure = 0;    // on its page
};

struct FiguresPage {
    std::string pdf;
    std::vector<VisibleLine> lines;
};

/// The pages have the drawing area's shape: a point is 0.2 mm under the hand.
inline constexpr double page_width_pt = 580.0;
inline constexpr double page_height_pt = 420.0;
inline constexpr double mm_per_pt = 0.2;

/// Six figures of kinds that follow each other from page to page, each with its seed's measures.
[[nodiscard]] FiguresPage figures_page(std::uint32_t seed);

/// Of the kinds.
[[nodiscard]] int figure_kinds();

}  // namespace touchline::testing
