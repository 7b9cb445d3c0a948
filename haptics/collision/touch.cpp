#include "haptics/collision/touch.h"

#include "haptics/collision/crossing.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

/// A motion seen from one segment.
struct Approach {
    Position from;
    Position way;
    double radius_m;
};

std::optional<Touch> touch_line(const Approach& motion, const Segment& s, Position e,
                                double length) {
    const Position w = motion.from - s.a;
    const double height = cross(e, w) / length;  // signed distance from the line, left positive
    const double rise = cross(e, motion.way) / length;
    const double side = height >= 0.0 ? 1.0 : -1.0;
    const double approach = -side * rise;
    const double gap = side * height - motion.radius_m;
    if (!(approach > approach_tolerance_m) || gap > approach - approach_tolerance_m) return {};
    const double fraction = std::clamp(gap / approach, 0.0, 1.0);
    const double t = dot(e, w + fraction * motion.way) / (length * length);
    if (!(t >= 0.0 && t <= 1.0)) return {};
    const Direction normal{-side * e.y / length, side * e.x / length};
    return Touch{fraction, t, normal, std::min(motion.radius_m, side * height)};
}

std::optional<Touch> touch_end(const Approach& motion, Position end, double parameter) {
    const double length = norm(motion.way);
    if (!(length > 0.0)) return {};
    const auto u = along<Direction>(motion.way, 1.0 / length);
    const Position w = motion.from - end;
    const double ahead = -dot(u, w);  // to the point nearest to the end
    const double pass = cross(u, w);  // distance at which it is passed
    const double nearest = ahead <= length ? std::abs(pass) : norm(w + motion.way);
    if (!(ahead > 0.0) || !(nearest < motion.radius_m - approach_tolerance_m)) return {};
    // Written as a product of the two ways to the circle: no cancellation at long ways.
    const double half_chord =
        std::sqrt((motion.radius_m - std::abs(pass)) * (motion.radius_m + std::abs(pass)));
    const double fraction = std::clamp((ahead - half_chord) / length, 0.0, 1.0);
    const Position centre = w + fraction * motion.way;
    const double distance = norm(centre);
    if (!(distance > 0.0)) return {};
    return Touch{fraction, parameter, along<Direction>(centre, 1.0 / distance),
                 std::min(motion.radius_m, distance), true};
}

std::optional<Touch> touch_point(Position from, Position to, const Segment& segment) {
    const auto met = crossing(from, to, segment);
    if (!met) return {};
    const Direction left = left_of(direction_of(segment.b - segment.a));
    const bool is_end = met->parameter == 0.0 || met->parameter == 1.0;
    return Touch{met->fraction, met->parameter, met->from_left ? left : -left, 0.0, is_end};
}

}  // namespace

std::optional<Touch> touch(Position from, Position to, double radius_m, const Segment& segment) {
    if (radius_m == 0.0) return touch_point(from, to, segment);
    const Position e = segment.b - segment.a;
    const double length = norm(e);
    const double start = foot(from, segment).distance_m;
    const Approach motion{from, to - from, std::min(radius_m, start)};
    // The disc comes as near to the line as it does to anything on it: a touched side is the first.
    if (length > 0.0) {
        if (const auto side = touch_line(motion, segment, e, length)) return side;
    }
    std::optional<Touch> first = touch_end(motion, segment.a, 0.0);
    const std::optional<Touch> second = touch_end(motion, segment.b, 1.0);
    if (second && (!first || second->fraction < first->fraction)) first = second;
    return first;
}

}  // namespace touchline
