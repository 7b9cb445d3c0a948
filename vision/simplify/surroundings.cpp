#include "vision/simplify/surroundings.h"

#include "config/types/angle.h"
#include "vision/contour/ink_parts.h"
#include "vision/contour/junctions.h"
#include "vision/contour/rings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double most_bend = radians(70.0);
constexpr double end_skip_mm = 0.5;  // the last points of a line are its worst
constexpr double end_span_mm = 4.0;

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
    std::map<PointKey, int> uses;
    for (const Chain& line : lines) {
        for (const EdgePoint& p : line.points) ++uses[key_of(p.at)];
    }
    std::vector<FreeEnd> ends;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (const EndId id : {front_of(i), back_of(i)}) {
            const cv::Point2d at = point_at(lines, id).at;
            if (!lines[i].is_closed && uses[key_of(at)] == 1) {
                ends.push_back(
                    {id, at,
                     ray_at(lines[i].points, is_back(id), end_skip_mm, end_span_mm).direction});
            }
        }
    }
    return ends;
}

constexpr double depth_cell_mm = 0.5;
constexpr double disc_radius_mm = 0.75;  // radius
constexpr double least_wall_mm = 15.0;   // shorter lines hide nothing
constexpr int rim = 12;                  // cells around the area, so that the outside is connected

cv::Point cell_of(cv::Point2d p) {
    return {rim + static_cast<int>(std::lround(p.x / depth_cell_mm)),
            rim + static_cast<int>(std::lround(p.y / depth_cell_mm))};
}

/// Non-zero where there is no line.
cv::Mat1b free_cells(const std::vector<Chain>& lines, cv::Size2d area_mm) {
    const cv::Point far = cell_of({area_mm.width, area_mm.height});
    cv::Mat1b cells(far.y + rim + 1, far.x + rim + 1, uchar{255});
    for (const Chain& line : lines) {
        if (length_of(line) < least_wall_mm) continue;
        std::vector<cv::Point> points;
        for (const EdgePoint& p : line.points) points.push_back(cell_of(p.at));
        cv::polylines(cells, points, line.is_closed, cv::Scalar(0), 1, cv::LINE_8);
    }
    return cells;
}

/// Returns the distances from the left, right, upper and lower edge of the picture.
std::array<double, 4> from_edges(const cv::Point2d& at, const cv::Rect2d& picture_mm) {
    return {at.x - picture_mm.x, picture_mm.br().x - at.x, at.y - picture_mm.y,
            picture_mm.br().y - at.y};
}

/// Returns the share of its points that lie within `reach_mm` of an edge of the picture.
double share_beside(const Chain& line, const cv::Rect2d& picture_mm, double reach_mm) {
    const auto beside = std::ranges::count_if(line.points, [&](const EdgePoint& p) {
        return std::ranges::min(from_edges(p.at, picture_mm)) < reach_mm;
    });
    return static_cast<double>(beside) / static_cast<double>(line.points.size());
}

int sides_near(const Chain& line, const cv::Rect2d& picture_mm, double reach_mm) {
    int sides = 0;
    for (std::size_t side = 0; side < 4; ++side) {
        sides += std::ranges::any_of(line.points, [&](const EdgePoint& p) {
            return from_edges(p.at, picture_mm)[side] < reach_mm;
        });
    }
    return sides;
}

/// The lines cut where others end on them, and which of the ends were one line before.
struct Arms {
    std::vector<Chain> chains;
    std::map<PointKey, std::vector<EndId>> meeting;  // of open ones
    std::map<PointKey, std::vector<std::pair<EndId, EndId>>> through;
};

std::set<PointKey> ends_of(const std::vector<Chain>& lines) {
    std::set<PointKey> ends;
    for (const Chain& line : lines) {
        if (!line.is_closed) {
            ends.insert(key_of(line.points.front().at));
            ends.insert(key_of(line.points.back().at));
        }
    }
    return ends;
}

/// Cuts one line into arms: from junction to junction.
void cut(Chain line, const std::set<PointKey>& junctions, Arms& arms) {
    const auto is_junction = [&](const EdgePoint& p) { return junctions.contains(key_of(p.at)); };
    if (line.is_closed) {
        const auto first = std::ranges::find_if(line.points, is_junction);
        if (first == line.points.end()) {
            arms.chains.push_back(std::move(line));
            return;
        }
        std::ranges::rotate(line.points, first);
        line.points.push_back(line.points.front());
    }
    const std::size_t before = arms.chains.size();
    std::vector<EdgePoint> points{line.points.front()};
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        points.push_back(line.points[i]);
        if (i + 1 == line.points.size() || is_junction(points.back())) {
            arms.chains.push_back(
                {std::exchange(points, {points.back()}), false, line.width_px, line.of});
        }
    }
    for (std::size_t arm = before; arm < arms.chains.size(); ++arm) {
        arms.meeting[key_of(arms.chains[arm].points.front().at)].push_back(front_of(arm));
        arms.meeting[key_of(arms.chains[arm].points.back().at)].push_back(back_of(arm));
        const bool is_last = arm + 1 == arms.chains.size();
        if (!is_last || line.is_closed) {
            const EndId next = front_of(is_last ? before : arm + 1);
            arms.through[key_of(arms.chains[arm].points.back().at)].emplace_back(back_of(arm),
                                                                                 next);
        }
    }
}

enum class Side { inside, round_a_thing, outside };

Side side_of(const Chain& line, const Outside& outside) {
    constexpr double mostly = 0.5;
    if (outside.share_of(line) <= mostly) return Side::inside;
    return outside.share_on_both_sides(line) > mostly ? Side::outside : Side::round_a_thing;
}

/// Returns the two ends that go round a thing at a junction where everything else lies within it;
/// or none.
std::vector<EndId> round_at(const std::vector<EndId>& meeting, const std::vector<Side>& sides) {
    std::vector<EndId> round;
    for (const EndId end : meeting) {
        const Side side = sides[chain_of(end)];
        if (side == Side::outside) return {};
        if (side == Side::round_a_thing) round.push_back(end);
    }
    return round.size() == 2 ? round : std::vector<EndId>();
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
            if (std::max(bend_i, bend_k) < most_bend) {
                joins.push_back({ends[i].id, ends[k].id, apart_mm * (1.0 + bend_i + bend_k)});
            }
        }
    }
    std::ranges::stable_sort(joins, {}, &Join::cost);
    std::vector<bool> is_taken(2 * lines.size(), false);
    JunctionSet set(end_skip_mm, end_span_mm);
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

Outside::Outside(const std::vector<Chain>& lines, cv::Size2d area_mm) {
    cv::Mat passable = depth_of(free_cells(lines, area_mm)) > disc_radius_mm / depth_cell_mm;
    constexpr uchar outside_mark = 128;
    cv::floodFill(passable, cv::Point(0, 0), cv::Scalar(outside_mark), nullptr, {}, {}, 8);
    to_outside_ = depth_of(passable != outside_mark);
}

double Outside::share_of(const Chain& line) const {
    constexpr float reached_cells = static_cast<float>(disc_radius_mm / depth_cell_mm + 1.5);
    const auto reached = std::ranges::count_if(line.points, [&](const EdgePoint& p) {
        return to_outside_(cell_of(p.at)) < reached_cells;
    });
    return static_cast<double>(reached) / static_cast<double>(line.points.size());
}

std::vector<double> Outside::shares_of(const std::vector<Chain>& lines) const {
    std::vector<double> shares(lines.size());
    std::ranges::transform(lines, shares.begin(),
                           [&](const Chain& line) { return share_of(line); });
    return shares;
}

double Outside::share_on_both_sides(const Chain& line) const {
    constexpr double beside_line_mm = 2.0;
    const auto is_out = [&](cv::Point2d p) {
        const cv::Point cell = cell_of(p);
        return !cv::Rect({}, to_outside_.size()).contains(cell) || to_outside_(cell) <= 0.0F;
    };
    std::size_t both = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const cv::Point2d at = line.points[i].at;
        const cv::Point2d along = at - line.points[i - 1].at;
        const cv::Point2d beside =
            beside_line_mm / std::max(1e-9, cv::norm(along)) * cv::Point2d(-along.y, along.x);
        both += is_out(at + beside) && is_out(at - beside) ? 1U : 0U;
    }
    return static_cast<double>(both) / static_cast<double>(line.points.size());
}

bool is_frame(const Chain& line, const cv::Rect2d& picture_mm) {
    const double reach_mm = 0.04 * std::min(picture_mm.width, picture_mm.height);
    return share_beside(line, picture_mm, reach_mm) >= 0.9 &&
           sides_near(line, picture_mm, reach_mm) >= 3;
}

bool is_rim(const Chain& line, const cv::Rect2d& picture_mm) {
    constexpr double uneven_mm = 0.1;
    return share_beside(line, picture_mm, 0.5 * line.width_px + uneven_mm) >= 0.9;
}

bool is_met(const Chain& line, const std::vector<Chain>& others) {
    constexpr double met_within_mm = 1.0;
    const auto ends_on_it = [&](const EdgePoint& end) {
        return std::ranges::any_of(line.points, [&](const EdgePoint& p) {
            return distance(p.at, end.at) <= met_within_mm;
        });
    };
    return std::ranges::any_of(others, [&](const Chain& other) {
        return !other.is_closed &&
               (ends_on_it(other.points.front()) || ends_on_it(other.points.back()));
    });
}

double held_area(const Chain& line) {
    return line.is_closed ? std::abs(area_within(line)) : 0.0;
}

std::vector<Chain> with_silhouettes_joined(std::vector<Chain> lines, const Outside& outside) {
    const std::set<PointKey> junctions = ends_of(lines);
    Arms arms;
    for (Chain& line : lines) cut(std::move(line), junctions, arms);
    std::vector<Side> sides;
    for (const Chain& arm : arms.chains) sides.push_back(side_of(arm, outside));
    JunctionSet set(0.0, 0.0);
    for (const auto& [place, meeting] : arms.meeting) {
        const std::vector<EndId> round = round_at(meeting, sides);
        if (!round.empty()) set.add_joint(round[0], round[1]);
        for (const auto& [a, b] : arms.through[place]) {
            if (!std::ranges::count(round, a) && !std::ranges::count(round, b)) set.add_joint(a, b);
        }
    }
    return set.assembled(std::move(arms.chains));
}

}  // namespace touchline
