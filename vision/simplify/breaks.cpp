#include "vision/simplify/breaks.h"

#include "vision/contour/ends.h"
#include "vision/contour/junctions.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <utility>

namespace touchline {
namespace {

constexpr double kMostBend = 70.0 * std::numbers::pi / 180.0;
constexpr double kSkip_mm = 0.5;  // the last points of a line are its worst
constexpr double kSpan_mm = 4.0;

struct FreeEnd {
    EndId id = 0;
    cv::Point2d at;
    cv::Point2d outward;
};

struct Join {
    EndId a = 0;
    EndId b = 0;
    double cost = 0.0;
};

std::vector<FreeEnd> free_ends(const std::vector<Chain>& lines) {
    std::map<Place, int> uses;
    for (const Chain& line : lines) {
        for (const EdgePoint& p : line.points) {
            ++uses[place_of(p.at)];
        }
    }
    std::vector<FreeEnd> ends;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (const EndId id : {front_of(i), back_of(i)}) {
            const std::vector<EdgePoint>& points = lines[i].points;
            const cv::Point2d at = is_back(id) ? points.back().at : points.front().at;
            if (!lines[i].is_closed && uses[place_of(at)] == 1) {
                ends.push_back({id, at, ray_at(points, is_back(id), kSkip_mm, kSpan_mm).direction});
            }
        }
    }
    return ends;
}

}  // namespace

std::vector<Chain> with_breaks_closed(std::vector<Chain> lines, double reach_mm) {
    std::vector<FreeEnd> ends = free_ends(lines);
    std::ranges::stable_sort(ends, {}, [](const FreeEnd& e) { return e.at.x; });
    std::vector<Join> joins;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        for (std::size_t k = i + 1; k < ends.size() && ends[k].at.x - ends[i].at.x < reach_mm;
             ++k) {
            const cv::Point2d across = ends[k].at - ends[i].at;
            const double apart_mm = cv::norm(across);
            const bool is_own = chain_of(ends[i].id) == chain_of(ends[k].id);
            if (apart_mm >= reach_mm ||
                (is_own && length_of(lines[chain_of(ends[i].id)]) < 4.0 * apart_mm)) {
                continue;
            }
            const bool is_touching = apart_mm < 0.25 * reach_mm;
            const double bend_i = is_touching ? 0.0 : angle_between(ends[i].outward, across);
            const double bend_k = is_touching ? 0.0 : angle_between(ends[k].outward, -across);
            if (std::max(bend_i, bend_k) < kMostBend) {
                joins.push_back({ends[i].id, ends[k].id, apart_mm * (1.0 + bend_i + bend_k)});
            }
        }
    }
    std::ranges::stable_sort(joins, {}, &Join::cost);
    std::vector<bool> is_taken(2 * lines.size(), false);
    JunctionSet set(kSkip_mm, kSpan_mm);
    bool is_any = false;
    for (const Join& join : joins) {
        if (!is_taken[join.a] && !is_taken[join.b]) {
            is_taken[join.a] = is_taken[join.b] = true;
            set.add_joint(join.a, join.b);
            is_any = true;
        }
    }
    return is_any ? set.assembled(std::move(lines)) : lines;
}

}  // namespace touchline
