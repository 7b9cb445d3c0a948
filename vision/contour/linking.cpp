#include "vision/contour/linking.h"

#include "config/types/angle.h"
#include "vision/contour/junctions.h"
#include "vision/contour/rings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace touchline {
namespace {

constexpr double frame_over_line = 0.7;  // a half disc is 0.64, a horizon 1
constexpr double least_roundness = 0.6;  // round a corner every way is long

/// The frame as a closed way, clockwise from its upper left corner.
class Frame {
  public:
    explicit Frame(cv::Size picture) : width_(picture.width), height_(picture.height) {}

    double length_px() const { return 2.0 * (width_ + height_); }

    /// Returns how far along the way a point on it lies.
    std::optional<double> place_of(const cv::Point2d& p) const {
        const double to_right = p.x + 0.5;
        const double to_bottom = p.y + 0.5;
        if (p.y == -0.5) return to_right;
        if (p.x == width_ - 0.5) return width_ + to_bottom;
        if (p.y == height_ - 0.5) return 2.0 * width_ + height_ - to_right;
        return p.x == -0.5 ? std::optional(length_px() - to_bottom) : std::nullopt;
    }

    /// Returns the way ahead from one place to another.
    double ahead(double from, double to) const {
        return std::fmod(to - from + length_px(), length_px());
    }

    /// Returns the corners between a place and another `way_px` further on, in this order.
    std::vector<cv::Point2d> corners_after(double from, double way_px) const {
        struct FrameCorner {
            double ahead_px;
            cv::Point2d at;
        };

        const double right = width_ - 0.5;
        const double bottom = height_ - 0.5;
        std::array<FrameCorner, 4> corners{{{ahead(from, 0.0), {-0.5, -0.5}},
                                            {ahead(from, width_), {right, -0.5}},
                                            {ahead(from, width_ + height_), {right, bottom}},
                                            {ahead(from, 2.0 * width_ + height_), {-0.5, bottom}}}};
        std::ranges::sort(corners, {}, &FrameCorner::ahead_px);
        std::vector<cv::Point2d> passed;
        for (const FrameCorner& corner : corners) {
            if (corner.ahead_px > 0.0 && corner.ahead_px < way_px) passed.push_back(corner.at);
        }
        return passed;
    }

  private:
    double width_;
    double height_;
};

/// Returns 1 for a disc, 0.77 for a quarter of one, 0.54 for half a square, less for a sliver.
double roundness(const Chain& ring) {
    const double length = length_of(ring);
    return 4.0 * std::numbers::pi * std::abs(area_within(ring)) / (length * length);
}

/// Returns the chain with the frame between its ends, the shorter way.
std::optional<Chain> closed_along(const Frame& frame, const Chain& chain) {
    const std::optional<double> front = frame.place_of(chain.points.front().at);
    const std::optional<double> back = frame.place_of(chain.points.back().at);
    if (!front || !back) return std::nullopt;
    const double clockwise = frame.ahead(*back, *front);
    const bool is_clockwise = clockwise <= frame.length_px() / 2.0;
    const double way_px = is_clockwise ? clockwise : frame.length_px() - clockwise;
    std::vector<cv::Point2d> corners = frame.corners_after(is_clockwise ? *back : *front, way_px);
    if (!is_clockwise) std::ranges::reverse(corners);
    Chain closed = chain;
    closed.is_closed = true;
    for (const cv::Point2d& at : corners) {
        closed.points.push_back({at, chain.points.back().strength, true});
    }
    const bool is_mostly_line = way_px < frame_over_line * length_of(chain);
    const bool is_round = corners.size() == 1 && roundness(closed) > least_roundness;
    return is_mostly_line || is_round ? std::optional(closed) : std::nullopt;
}

/// Returns where a ray (`way`: unit vector) from inside the picture leaves it, exactly on the side
/// through which it leaves; nothing if that is `far_px` away or more.
std::optional<cv::Point2d> exit_near(const cv::Point2d& from, const cv::Point2d& way,
                                     cv::Size picture, double far_px) {
    const double right = picture.width - 0.5;
    const double bottom = picture.height - 0.5;
    const double side_x = way.x < 0.0 ? -0.5 : right;
    const double side_y = way.y < 0.0 ? -0.5 : bottom;
    const double to_x = way.x != 0.0 ? (side_x - from.x) / way.x : far_px;
    const double to_y = way.y != 0.0 ? (side_y - from.y) / way.y : far_px;
    if (std::min(to_x, to_y) >= far_px) return std::nullopt;
    if (to_x < to_y) return cv::Point2d(side_x, std::clamp(from.y + to_x * way.y, -0.5, bottom));
    return cv::Point2d(std::clamp(from.x + to_y * way.x, -0.5, right), side_y);
}

/// Closes a line with both ends exactly on the frame along it, the shorter way, through the corners
/// on that way (fixed points). It does so if the way is less than 0.7 of the line's length, or if
/// it passes one corner and the shape is as round as a quarter disc, not a strip or a triangle: a
/// shape cut off by the frame is one shape, a horizon is not. O(points).
void close_along_frame(std::vector<Chain>& chains, cv::Size picture) {
    const Frame frame(picture);
    for (Chain& chain : chains) {
        if (!chain.is_closed && chain.points.size() > 2) {
            if (std::optional<Chain> closed = closed_along(frame, chain)) {
                chain = std::move(*closed);
            }
        }
    }
}

constexpr double least_cell_px = 4.0;         // a grid of smaller cells costs more than it saves
constexpr double ray_span_px = 6.0;           // length of line that shows its direction
constexpr double own_gap_over_length = 0.05;  // a ring with a break is still a ring
// Where a line may meet another, off its course.
constexpr double cone = radians(70.0);

/// Two ends that may be one line, and the cost of joining them in pixels.
struct GapCandidate {
    double cost_px = 0.0;
    EndId a = 0;
    EndId b = 0;
};

class Linker {
  public:
    Linker(std::vector<Chain> lines, cv::Size picture, const Reach& reach)
        : lines_(std::move(lines)),
          picture_(picture),
          reach_(reach),
          is_free_(2 * lines_.size(), false),
          rays_(2 * lines_.size()) {}

    Linked run() {
        lead_to_frame();
        const PointGrid grid(lines_, picture_,
                             std::max({reach_.gap_px, reach_.junction_px, least_cell_px}));
        JunctionSet junctions(reach_.blur_px, ray_span_px);
        meet_ends(grid, junctions);
        const std::vector<std::optional<Meeting>> meetings = nearest_meetings(grid);
        const int gaps_closed = close_gaps(grid, meetings, junctions);
        for (EndId end = 0; end < is_free_.size(); ++end) {
            if (is_free_[end] && meetings[end] && length_of_chain(end) >= reach_.shortest_px) {
                junctions.add_meeting(end, meetings[end]->host);
            }
        }
        Linked result{junctions.assembled(std::move(lines_)), gaps_closed, junctions.size()};
        close_along_frame(result.chains, picture_);
        return result;
    }

  private:
    /// Where an end would meet another line.
    struct Meeting {
        PointRef host;
        double distance_px = 0.0;
    };

    const EdgePoint& point_at(EndId end) const { return touchline::point_at(lines_, end); }

    double length_of_chain(EndId end) const { return lengths_[chain_of(end)]; }

    /// Leads an end beside the frame to it, so that it is no loose end any more. All others are
    /// loose.
    void lead_to_frame() {
        for (std::size_t c = 0; c < lines_.size(); ++c) {
            lengths_.push_back(length_of(lines_[c]));
            for (const EndId end : {front_of(c), back_of(c)}) {
                if (lines_[c].is_closed) continue;
                rays_[end] = ray_at(lines_[c].points, is_back(end), 1.0, ray_span_px);
                EdgePoint last = point_at(end);
                const std::optional<cv::Point2d> exit =
                    exit_near(last.at, rays_[end].direction, picture_, reach_.blur_px + 2.0);
                is_free_[end] = !exit;
                if (exit) {
                    last.at = *exit;
                    last.is_fixed = true;
                    std::vector<EdgePoint>& points = lines_[c].points;
                    points.insert(is_back(end) ? points.end() : points.begin(), last);
                }
            }
        }
    }

    /// Returns the end at a point, if it is a free one.
    std::optional<EndId> free_end_at(const PointRef& ref) const {
        const Chain& chain = lines_[ref.chain];
        if (chain.is_closed) return std::nullopt;
        if (ref.index == 0 && is_free_[front_of(ref.chain)]) return front_of(ref.chain);
        if (ref.index + 1 == chain.points.size() && is_free_[back_of(ref.chain)]) {
            return back_of(ref.chain);
        }
        return std::nullopt;
    }

    /// Makes three or more free ends together a junction.
    void meet_ends(const PointGrid& grid, JunctionSet& junctions) {
        for (EndId end = 0; end < is_free_.size(); ++end) {
            if (!is_free_[end]) continue;
            std::vector<EndId> together;
            const cv::Point2d centre = point_at(end).at;
            grid.near(centre, reach_.junction_px, [&](const PointRef& ref) {
                const std::optional<EndId> other = free_end_at(ref);
                if (other && distance(point_at(*other).at, centre) <= reach_.junction_px) {
                    together.push_back(*other);
                }
            });
            if (together.size() < 3) continue;
            cv::Point2d sum;
            for (const EndId other : together) {
                sum += point_at(other).at;
                is_free_[other] = false;
            }
            junctions.add_cluster(together, sum * (1.0 / static_cast<double>(together.size())));
        }
    }

    /// Finds for each free end the best place on another line (or far along its own) within reach
    /// and ahead.
    std::vector<std::optional<Meeting>> nearest_meetings(const PointGrid& grid) const {
        std::vector<std::optional<Meeting>> meetings(is_free_.size());
        for (EndId end = 0; end < is_free_.size(); ++end) {
            if (!is_free_[end]) continue;
            double best = reach_.junction_px * (1.0 + cone);
            grid.near(point_at(end).at, reach_.junction_px, [&](const PointRef& ref) {
                const cv::Point2d step = lines_[ref.chain].points[ref.index].at - point_at(end).at;
                const double angle = angle_between(rays_[end].direction, step);
                const double cost = cv::norm(step) * (1.0 + angle);
                if (cv::norm(step) <= reach_.junction_px && angle <= cone && cost < best &&
                    can_host(ref, end)) {
                    best = cost;
                    meetings[end] = Meeting{ref, cv::norm(step)};
                }
            });
        }
        return meetings;
    }

    /// True for inner points of other lines that are not specks, unless one of their free ends is
    /// as near (then the two ends belong together); on the end's own line, for points a good way
    /// back.
    bool can_host(const PointRef& ref, EndId end) const {
        const Chain& host = lines_[ref.chain];
        const auto is_near_end = [&](EndId other) {
            return other != end && is_free_[other] &&
                   distance(point_at(other).at, point_at(end).at) <= reach_.junction_px;
        };
        if (lengths_[ref.chain] < reach_.shortest_px) return false;
        if (!host.is_closed &&
            (ref.index < 2 || ref.index + 3 > host.points.size() ||
             is_near_end(front_of(ref.chain)) || is_near_end(back_of(ref.chain)))) {
            return false;
        }
        const std::size_t back = is_back(end) ? host.points.size() - 1 - ref.index : ref.index;
        return ref.chain != chain_of(end) || static_cast<double>(back) > 4.0 * reach_.junction_px;
    }

    int close_gaps(const PointGrid& grid, const std::vector<std::optional<Meeting>>& meetings,
                   JunctionSet& junctions) {
        std::vector<GapCandidate> candidates;
        for (EndId a = 0; a < is_free_.size(); ++a) {
            if (!is_free_[a]) continue;
            grid.near(point_at(a).at, reach_.gap_px, [&](const PointRef& ref) {
                const std::optional<EndId> b = free_end_at(ref);
                if (b && a < *b) consider_gap(a, *b, meetings, candidates);
            });
            if (!is_back(a) && is_free_[a + 1]) consider_own_gap(a, candidates);
        }
        std::ranges::stable_sort(candidates, {}, &GapCandidate::cost_px);
        int closed = 0;
        for (const GapCandidate& c : candidates) {
            if (is_free_[c.a] && is_free_[c.b]) {
                is_free_[c.a] = is_free_[c.b] = false;
                junctions.add_joint(c.a, c.b);
                ++closed;
            }
        }
        return closed;
    }

    void consider_gap(EndId a, EndId b, const std::vector<std::optional<Meeting>>& meetings,
                      std::vector<GapCandidate>& candidates) const {
        const double gap = distance(point_at(a).at, point_at(b).at);
        for (const EndId end : {a, b}) {  // a line between the ends is met, not crossed
            if (meetings[end] && meetings[end]->distance_px < gap) return;
        }
        const double cost = gap * (1.0 + bending(a, b));
        if (cost <= reach_.gap_px || gap <= reach_.junction_px) candidates.push_back({cost, a, b});
    }

    void consider_own_gap(EndId front, std::vector<GapCandidate>& candidates) const {
        const double gap = distance(point_at(front).at, point_at(front + 1).at);
        const double limit =
            std::min(own_gap_over_length * length_of_chain(front), 2.0 * reach_.gap_px);
        if (gap <= limit && bending(front, front + 1) < std::numbers::pi / 2.0) {
            candidates.push_back({gap * (1.0 + bending(front, front + 1)), front, front + 1});
        }
    }

    /// Returns how much a line turns from one end over the straight bridge into the other, radians.
    double bending(EndId a, EndId b) const {
        const cv::Point2d bridge = point_at(b).at - point_at(a).at;
        return cv::norm(bridge) > 0.0 ? angle_between(rays_[a].direction, bridge) +
                                            angle_between(bridge, -rays_[b].direction)
                                      : angle_between(rays_[a].direction, -rays_[b].direction);
    }

    std::vector<Chain> lines_;
    cv::Size picture_;
    Reach reach_;
    std::vector<double> lengths_;  // of each line
    std::vector<bool> is_free_;    // of each end: open, not at the frame, not joined yet
    std::vector<Ray> rays_;        // of each end of an open line
};

}  // namespace

Linked linked(std::vector<Chain> lines, cv::Size picture, const Reach& reach) {
    return Linker(std::move(lines), picture, reach).run();
}

}  // namespace touchline
