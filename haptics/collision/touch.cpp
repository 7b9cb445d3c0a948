#include "haptics/collision/touch.h"

#include "haptics/collision/box.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchline {
namespace {

/// A sum of doubles kept exactly, as non-overlapping parts, smallest first.
class Expansion {
  public:
    void add(double x) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size_; ++i) {
            const double sum = x + parts_[i];
            const double virtual_part = sum - x;
            const double lost = (x - (sum - virtual_part)) + (parts_[i] - virtual_part);
            x = sum;
            if (lost != 0.0) parts_[kept++] = lost;
        }
        if (x != 0.0) parts_[kept++] = x;
        size_ = kept;
    }

    void add_product(double a, double b) {
        const double product = a * b;
        add(std::fma(a, b, -product));
        add(product);
    }

    /// The value to 1 ulp; its sign is exact.
    [[nodiscard]] double value() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < size_; ++i) sum += parts_[i];
        return sum;
    }

  private:
    std::array<double, 12> parts_{};  // six products of two parts each
    std::size_t size_ = 0;
};

/// Returns twice the area of the triangle a, b, c, to 1 ulp.
double exact_area(Position a, Position b, Position c) {
    Expansion sum;
    sum.add_product(b.x, c.y);
    sum.add_product(-b.x, a.y);
    sum.add_product(-a.x, c.y);
    sum.add_product(-b.y, c.x);
    sum.add_product(b.y, a.x);
    sum.add_product(a.y, c.x);
    return sum.value();
}

bool is_between(Position a, Position b, Position p) {
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
}

/// Returns where p, on the line through a and b, lies between them; 0 if they are one point.
double share_between(Position a, Position b, Position p) {
    const Position e = b - a;
    const bool is_wide = std::abs(e.x) >= std::abs(e.y);
    const double length = is_wide ? e.x : e.y;
    return length == 0.0 ? 0.0 : (is_wide ? p.x - a.x : p.y - a.y) / length;
}

/// For a way and a segment on one line, or if one of them is a point.
std::optional<Crossing> collinear_crossing(Position from, Position to, const Segment& segment) {
    if (is_between(segment.a, segment.b, from)) {
        return Crossing{0.0, share_between(segment.a, segment.b, from), true};
    }
    std::optional<Crossing> first;
    for (const double end : {0.0, 1.0}) {
        const Position p = end == 0.0 ? segment.a : segment.b;
        if (!is_between(from, to, p)) continue;
        const double fraction = share_between(from, to, p);
        if (!first || fraction < first->fraction) first = Crossing{fraction, end, true};
    }
    return first;
}

double share(double from, double to) {
    return std::abs(from) / (std::abs(from) + std::abs(to));
}

int sign_of(double x) {
    return x > 0.0 ? 1 : (x < 0.0 ? -1 : 0);
}

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

/// p as seen from the segment, at a share of its way.
struct Seen {
    Position edge;
    Position to_p;
};

Seen seen_at(Position p, const Segment& from, const Segment& to, double share) {
    const Position a = from.a + share * (to.a - from.a);
    const Position b = from.b + share * (to.b - from.b);
    return {b - a, p - a};
}

/// Whether a height that changes evenly stays out of reach of 0 on one side.
bool stays_off(double height, double rise, double reach) {
    return std::min(height, height + rise) > reach || std::max(height, height + rise) < -reach;
}

/// Returns the shares in (0, 1] at which c0 + c1 x + c2 x^2 is 0, in order; NaN for a missing one.
std::array<double, 2> roots(double c0, double c1, double c2) {
    std::array<double, 2> found{NAN, NAN};
    const double square = c1 * c1 - 4.0 * c0 * c2;
    if (square < 0.0) return found;
    // In this form nothing cancels. If c2 is 0, one of the two is the root of the line.
    const double q = -0.5 * (c1 + std::copysign(std::sqrt(square), c1));
    found = {c0 / q, q / c2};
    if (!(found[0] <= found[1])) std::swap(found[0], found[1]);
    return found;
}

}  // namespace

int orientation(Position a, Position b, Position c) {
    const double left = (b.x - a.x) * (c.y - a.y);
    const double right = (b.y - a.y) * (c.x - a.x);
    const double fast = left - right;
    const double doubt = 4e-16 * (std::abs(left) + std::abs(right));  // 3.33e-16 after Shewchuk
    if (std::abs(fast) > doubt) return sign_of(fast);
    return sign_of(exact_area(a, b, c));
}

std::optional<Crossing> crossing(Position from, Position to, const Segment& segment) {
    const auto [a, b] = segment;
    const int side_of_from = orientation(a, b, from);
    const int side_of_to = orientation(a, b, to);
    if (side_of_from * side_of_to > 0) return {};
    const int side_of_a = orientation(from, to, a);
    const int side_of_b = orientation(from, to, b);
    if (side_of_a * side_of_b > 0) return {};
    const bool is_collinear =
        (side_of_from == 0 && side_of_to == 0) || (side_of_a == 0 && side_of_b == 0);
    if (is_collinear) return collinear_crossing(from, to, segment);
    return Crossing{share(exact_area(a, b, from), exact_area(a, b, to)),
                    share(exact_area(from, to, a), exact_area(from, to, b)), side_of_from >= 0};
}

std::optional<Touch> touch(Position from, Position to, double radius_m, const Segment& segment) {
    if (radius_m == 0.0) return touch_point(from, to, segment);
    const Position e = segment.b - segment.a;
    const double height = cross(e, from - segment.a);  // times the length
    const double rise = cross(e, to - from);
    if (stays_off(height, rise, radius_m * length_bound(e))) return {};
    const Foot below = foot(from, segment);
    // Away from a line that it lies beside, a disc only gets farther from the segment.
    const bool is_beside = below.parameter > 0.0 && below.parameter < 1.0;
    if (is_beside && height * rise >= 0.0) return {};
    const double start = below.distance_m;
    if (start - radius_m > length_bound(to - from)) return {};  // too far away
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
        const Descent descent = descent_of(motion, segment, e, norm(e));
        // The disc comes at least as near to the line as to any point of the segment, so a touched
        // side is the first.
        if (const auto side = touch_line(motion, descent)) return side;
        take(touch_on_entering(motion, descent));
    }
    take(touch_end(motion, segment.a, 0.0));
    take(touch_end(motion, segment.b, 1.0));
    return first;
}

std::optional<WallMeeting> meeting(Position p, const Segment& from, const Segment& to) {
    const Seen start = seen_at(p, from, to, 0.0);
    const Seen end = seen_at(p, from, to, 1.0);
    const Position turn = end.edge - start.edge;
    const Position shift = end.to_p - start.to_p;
    const double c0 = cross(start.edge, start.to_p);
    const double c1 = cross(start.edge, shift) + cross(turn, start.to_p);
    const double c2 = cross(turn, shift);
    // A parabola stays inside the triangle of its ends and the crossing of its tangents there.
    const double between = c0 + 0.5 * c1;
    const double last = c0 + c1 + c2;
    if ((c0 > 0.0 && between > 0.0 && last > 0.0) || (c0 < 0.0 && between < 0.0 && last < 0.0)) {
        return {};
    }
    for (const double share : roots(c0, c1, c2)) {
        if (!(share >= 0.0 && share <= 1.0)) continue;
        const Seen then = seen_at(p, from, to, share);
        const double square = dot(then.edge, then.edge);
        const double along_it = dot(then.to_p, then.edge);
        const double beyond = 0.25 * contact_skin_m * std::sqrt(square);
        if (!(along_it >= -beyond && along_it <= square + beyond)) continue;
        const double parameter =
            square > 0.0 ? std::min(std::max(along_it / square, 0.0), 1.0) : 0.0;
        return WallMeeting{share, parameter, c0 > 0.0};
    }
    return {};
}

}  // namespace touchline
