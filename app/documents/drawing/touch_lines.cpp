#include "app/documents/drawing/touch_lines.h"

#include "config/types/map_frame.h"
#include "vision/contour/chain.h"
#include "vision/simplify/detail_limits.h"
#include "vision/simplify/segment_grid.h"
#include "vision/simplify/shaping.h"
#include "vision/simplify/surroundings.h"
#include "vision/simplify/zoom.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace touchline {
namespace {

constexpr double step_mm = 0.5;     // between points: finer than a fingertip tells
constexpr double meeting_mm = 2.0;  // an end this near to a line is meant to meet it
constexpr double look_cell_mm = 2.0;
constexpr std::size_t most_near = 40;   // segments of the same stroke beside one, on average
constexpr double closing_share = 0.25;  // of a stroke's length: a longer gap is meant to be open

cv::Size2d size_mm(const Area& area) {
    const ViewBox box = view_box_of(area);
    return {box.width_mm, box.height_mm};
}

EdgePoint in_mm(Position p_W, const ViewBox& box) {
    const ViewBoxPoint at = to_view_box(p_W, box);
    return {{at.u_mm, at.v_mm}};
}

/// Each place once, and inside the area.
Chain read_stroke(std::span<const Position> stroke_W, const Area& area) {
    const ViewBox box = view_box_of(area);
    Chain line;
    for (const Position& p : stroke_W)
        if (is_finite(p)) line.points.push_back(in_mm(p, box));
    line = within(std::move(line), size_mm(area));
    const auto again = std::ranges::unique(
        line.points, [](const EdgePoint& a, const EdgePoint& b) { return a.at == b.at; });
    line.points.erase(again.begin(), again.end());
    return line;
}

/// The nearest vertex of the lines that is near enough to be meant.
std::optional<EdgePoint> vertex_near(const EdgePoint& end, std::span<const Outline> others,
                                     const ViewBox& box) {
    std::optional<EdgePoint> nearest;
    double least_mm = meeting_mm;
    for (const Outline& other : others) {
        for (const Position& p : other.points) {
            const EdgePoint vertex = in_mm(p, box);
            const double apart_mm = distance(vertex.at, end.at);
            if (!(apart_mm <= least_mm)) continue;
            least_mm = apart_mm;
            nearest = vertex;
        }
    }
    return nearest;
}

void join_ends(Chain& line, std::span<const Outline> others, const Area& area) {
    const double gap_mm = distance(line.points.front().at, line.points.back().at);
    if (gap_mm <= std::min(small_break_mm, closing_share * length_of(line))) {
        line.is_closed = true;
        if (gap_mm == 0.0) line.points.pop_back();
        return;
    }
    const ViewBox box = view_box_of(area);
    if (const auto foot = vertex_near(line.points.front(), others, box))
        line.points.insert(line.points.begin(), *foot);
    if (const auto foot = vertex_near(line.points.back(), others, box))
        line.points.push_back(*foot);
}

/// Even points, each of which may be a corner.
Chain with_even_points(Chain line) {
    const auto parts = static_cast<int>(std::clamp(std::ceil(length_of(line) / step_mm), 4.0, 1e6));
    if (line.is_closed) line.points.push_back(line.points.front());
    line.points = evenly_spaced(line.points, parts);
    if (line.is_closed) line.points.pop_back();
    for (EdgePoint& point : line.points) point.is_fixed = true;
    return line;
}

/// Looks once over the line, and no longer than it takes to know; taking it apart looks again for
/// each crossing.
bool is_scribble(const Chain& line, const Area& area) {
    SegmentGrid grid(size_mm(area), look_cell_mm);
    const std::size_t count = line.points.size() - (line.is_closed ? 0 : 1);
    std::vector<std::size_t> seen_from(count, count);  // a grid tells some segments twice
    std::size_t near = 0;
    std::size_t crossings = 0;
    for (std::size_t i = 0; i < count && near <= most_near * count && crossings <= most_crossings;
         ++i) {
        const LineSegment here{line.points[i].at, line.points[(i + 1) % line.points.size()].at, 0,
                               i};
        grid.near(here.a, here.b, 0.0, [&](const LineSegment& before) {
            if (before.index + 1 >= i || std::exchange(seen_from[before.index], i) == i) return;
            ++near;
            if (crossing_of(before, here)) ++crossings;
        });
        grid.add(here);
    }
    return near > most_near * count || crossings > most_crossings;
}

}  // namespace

std::optional<std::vector<Outline>> touch_lines(std::span<const Position> stroke_W,
                                                std::span<const Outline> others, const Area& area) {
    std::vector<Outline> outlines;
    Chain line = read_stroke(stroke_W, area);
    if (line.points.size() < 2 || length_of(line) < shortest_line_mm) return outlines;
    join_ends(line, others, area);
    const DetailLimits limits = limits_for(most_detail, area);
    const Chain smooth = shaped(with_even_points(std::move(line)),
                                {step_mm, limits.tolerance_mm, limits.least_feature_mm});
    if (is_scribble(smooth, area)) return std::nullopt;
    const std::vector<Chain> parts = without_self_crossings(smooth, least_apart_mm);
    const double sum_mm = std::transform_reduce(parts.begin(), parts.end(), 0.0, std::plus<>(),
                                                [](const Chain& part) { return length_of(part); });
    if (!(sum_mm >= shortest_line_mm)) return outlines;
    for (const Chain& part : parts) outlines.push_back(outline_of(part, area));
    return outlines;
}

}  // namespace touchline
