#include "vision/simplify/loops.h"

#include "vision/simplify/map_grid.h"

#include <algorithm>
#include <optional>

namespace touchline {
namespace {

constexpr double kCell_mm = 2.0;
constexpr int kMostCuts = 200;  // a line with more is a scribble, and the rest of it is dropped

struct SelfCrossing {
    std::size_t first = 0;   // segment that is crossed
    std::size_t second = 0;  // later segment that crosses it
    cv::Point2d at;
};

/// Returns where two segments, from `low` on, cross once their points are on the grid; nothing if
/// they only touch.
std::optional<cv::Point2d> crossing_on_grid(const LineSegment& s, const LineSegment& t,
                                            cv::Point2d low) {
    if (!cross_on_map_grid({s.a + low, s.b + low}, {t.a + low, t.b + low})) {
        return std::nullopt;
    }
    const cv::Point2d u = s.b - s.a;
    const cv::Point2d v = t.b - t.a;
    const double area = u.cross(v);
    return area == 0.0 ? nearest_on(s, t.a)
                       : s.a + std::clamp((t.a - s.a).cross(v) / area, 0.0, 1.0) * u;
}

/// Returns where they meet, ends included.
std::optional<cv::Point2d> meeting(const LineSegment& s, const LineSegment& t, cv::Point2d) {
    return crossing_of(s, t);
}

using CrossingOf = std::optional<cv::Point2d> (*)(const LineSegment&, const LineSegment&,
                                                  cv::Point2d);

/// Returns the crossing that closes the shortest loop (in segments).
std::optional<SelfCrossing> self_crossing(const Chain& line, CrossingOf crossing) {
    const std::size_t n = line.points.size();
    const std::size_t count = line.is_closed ? n : n - 1;
    cv::Point2d low = line.points.front().at;
    cv::Point2d high = low;
    for (const EdgePoint& p : line.points) {
        low = {std::min(low.x, p.at.x), std::min(low.y, p.at.y)};
        high = {std::max(high.x, p.at.x), std::max(high.y, p.at.y)};
    }
    SegmentGrid grid({high.x - low.x, high.y - low.y}, kCell_mm);
    std::optional<SelfCrossing> best;
    for (std::size_t i = 0; i < count; ++i) {
        const LineSegment here{line.points[i].at - low, line.points[(i + 1) % n].at - low, 0, i};
        grid.near(here.a, here.b, 0.0, [&](const LineSegment& before) {
            const std::size_t apart = i - before.index;
            const bool is_neighbour = apart <= 1 || (line.is_closed && apart + 1 >= count);
            const std::optional<cv::Point2d> at =
                is_neighbour ? std::nullopt : crossing(before, here, low);
            if (at && (!best || apart < best->second - best->first)) {
                best = {before.index, i, *at + low};
            }
        });
        grid.add(here);
    }
    return best;
}

std::vector<Chain> taken_apart(const Chain& line, double least_mm, CrossingOf crossing) {
    std::vector<Chain> parts;
    std::vector<Chain> open{line};
    int cuts = 0;
    while (!open.empty()) {
        Chain part = std::move(open.back());
        open.pop_back();
        const std::optional<SelfCrossing> found =
            part.points.size() < 4 ? std::nullopt : self_crossing(part, crossing);
        if (!found) {
            parts.push_back(std::move(part));
            continue;
        }
        if (++cuts > kMostCuts) {
            continue;
        }
        const auto first = part.points.begin() + static_cast<std::ptrdiff_t>(found->first) + 1;
        const auto second = part.points.begin() + static_cast<std::ptrdiff_t>(found->second) + 1;
        const EdgePoint at{found->at, first->strength, true};
        Chain loop{{at}, true, part.width_px};
        loop.points.insert(loop.points.end(), first, second);
        Chain rest{{part.points.begin(), first}, part.is_closed, part.width_px};
        rest.points.push_back(at);
        rest.points.insert(rest.points.end(), second, part.points.end());
        for (Chain* piece : {&loop, &rest}) {
            if (length_of(*piece) >= least_mm && piece->points.size() > 1) {
                open.push_back(std::move(*piece));
            }
        }
    }
    std::ranges::stable_sort(parts, std::ranges::greater{}, length_of);
    return parts;
}

}  // namespace

std::vector<Chain> without_self_crossings(const Chain& line, double least_mm) {
    return taken_apart(line, least_mm, meeting);
}

bool crosses_itself_in_map(const Chain& line) {
    return line.points.size() > 3 && self_crossing(line, crossing_on_grid);
}

std::vector<Chain> without_crossings_in_map(const Chain& line) {
    return taken_apart(line, 0.0, crossing_on_grid);
}

}  // namespace touchline
