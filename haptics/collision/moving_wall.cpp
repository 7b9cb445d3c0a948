#include "haptics/collision/moving_wall.h"

#include "haptics/collision/touch.h"

#include <array>
#include <cmath>

namespace touchline {
namespace {

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

std::optional<WallMeeting> meeting(Position p, const Segment& from, const Segment& to) {
    const Seen start = seen_at(p, from, to, 0.0);
    const Seen end = seen_at(p, from, to, 1.0);
    const Position turn = end.edge - start.edge;
    const Position shift = end.to_p - start.to_p;
    const double c0 = cross(start.edge, start.to_p);
    const double c1 = cross(start.edge, shift) + cross(turn, start.to_p);
    const double c2 = cross(turn, shift);
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
