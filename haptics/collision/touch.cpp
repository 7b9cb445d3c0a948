#include "haptics/collision/touch.h"

#include "haptics/collision/crossing.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

// A way whose point nearest to an end lies no further ahead than this passes the end by. Rounding
// makes this much of a tangent, and it brings a disc that keeps half a skin or more nearer by at
// most 1e-21 m.
constexpr double tangential_m = 1e-16;

/// A motion seen from one segment.
struct Course {
    Position from;
    Position way;
    double radius_m;
    double tolerance_m;  // what does not count as coming nearer
};

/// A motion towards the line of a segment, measured along and across it.
struct Descent {
    Direction along;
    double length_m;
    double side;        // of the start: +1 left, -1 right
    double height_m;    // of the start above the line, >= 0
    double approach_m;  // lost over the whole motion
    double start;       // of the foot on the segment, 0 ... 1 within it
    double advance;     // of the foot over the whole motion
};

Descent descent_of(const Course& motion, const Segment& s, Position e, double length) {
    const Position w = motion.from - s.a;
    const double height = cross(e, w) / length;  // left positive
    const double side = height >= 0.0 ? 1.0 : -1.0;
    const double square = length * length;
    return {along<Direction>(e, 1.0 / length),
            length,
            side,
            side * height,
            -side * cross(e, motion.way) / length,
            dot(e, w) / square,
            dot(e, motion.way) / square};
}

Touch side_touch(const Course& motion, const Descent& d, double fraction, double parameter,
                 double height_m) {
    return {fraction, parameter, d.side * left_of(d.along), std::min(motion.radius_m, height_m)};
}

std::optional<Touch> touch_line(const Course& motion, const Descent& d) {
    const double gap = d.height_m - motion.radius_m;
    if (!(d.approach_m > motion.tolerance_m) || gap > d.approach_m - motion.tolerance_m) return {};
    const double fraction = std::clamp(gap / d.approach_m, 0.0, 1.0);
    const double t = d.start + fraction * d.advance;
    if (!(t >= 0.0 && t <= 1.0)) return {};
    // Over the segment it comes no nearer any more: its end decides, or else a proxy that leaves an
    // end along the line would be stopped by what it leaves.
    const double ahead = d.advance > 0.0 ? 1.0 - t : t;
    const bool is_leaving = ahead * d.approach_m <= motion.tolerance_m * std::abs(d.advance);
    if (d.advance != 0.0 && is_leaving) return {};
    return side_touch(motion, d, fraction, t, d.height_m);
}

/// The disc has passed an end so close to its radius that the end did not count as touched, and is
/// still coming nearer as its foot enters the segment.
std::optional<Touch> touch_on_entering(const Course& motion, const Descent& d) {
    const bool is_before = d.start < 0.0 && d.advance > 0.0;
    const bool is_after = d.start > 1.0 && d.advance < 0.0;
    if (!is_before && !is_after) return {};
    const double end = is_before ? 0.0 : 1.0;
    const double fraction = (end - d.start) / d.advance;
    const double height_m = d.height_m - fraction * d.approach_m;
    const bool is_in_reach = height_m > 0.0 && height_m <= motion.radius_m;
    if (!(fraction <= 1.0) || !is_in_reach) return {};
    if (!((1.0 - fraction) * d.approach_m > motion.tolerance_m)) return {};
    return side_touch(motion, d, fraction, end, height_m);
}

std::optional<Touch> touch_end(const Course& motion, Position end, double parameter) {
    const double length = norm(motion.way);
    if (!(length > 0.0)) return {};
    const auto u = along<Direction>(motion.way, 1.0 / length);
    const Position w = motion.from - end;
    const double ahead = -dot(u, w);  // to the point nearest to the end
    const double pass = cross(u, w);  // distance at which it is passed
    const double nearest = ahead <= length ? std::abs(pass) : norm(w + motion.way);
    if (!(ahead > tangential_m) || !(nearest < motion.radius_m - motion.tolerance_m)) return {};
    // Written as a product of the two ways to the circle, so that nothing cancels at long ways.
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
    // Over many motions a tolerance would add up, so there is none once half the skin is gone, even
    // for a disc that keeps less than its radius by now.
    const bool is_kept = start > std::max(radius_m - 0.5 * contact_skin_m, 0.5 * contact_skin_m);
    const Course motion{from, to - from, std::min(radius_m, start),
                        is_kept ? approach_tolerance_m : 0.0};
    std::optional<Touch> first;
    const auto take = [&first](const std::optional<Touch>& next) {
        if (next && (!first || next->fraction < first->fraction)) first = next;
    };
    if (!is_point(segment)) {
        const Descent descent = descent_of(motion, segment, e, length);
        // The disc comes at least as near to the line as to any point of the segment, so a touched
        // side is the first.
        if (const auto side = touch_line(motion, descent)) return side;
        take(touch_on_entering(motion, descent));
    }
    take(touch_end(motion, segment.a, 0.0));
    take(touch_end(motion, segment.b, 1.0));
    return first;
}

}  // namespace touchline
