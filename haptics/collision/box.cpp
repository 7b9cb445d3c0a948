#include "haptics/collision/box.h"

namespace touchline {
namespace {

/// Returns true if `other` lies further than `reach_m` outside one side of the box.
bool separates(const Box& box, const Box& other, double reach_m) {
    const Shadow at = shadow(other, box.origin, box.axis);
    const double square = dot(box.axis, box.axis);
    const double grow = reach_m * length_bound(box.axis);
    return (at.along_low > box.along_high * square + grow) |
           (at.along_high < box.along_low * square - grow) |
           (at.across_low > box.across_high * square + grow) |
           (at.across_high < box.across_low * square - grow);
}

}  // namespace

double distance_m(const Box& box, Position p) {
    const double square = dot(box.axis, box.axis);
    const double s = dot(box.axis, p - box.origin);
    const double n = cross(box.axis, p - box.origin);
    const double beside = std::max({0.0, box.along_low * square - s, s - box.along_high * square});
    const double off = std::max({0.0, box.across_low * square - n, n - box.across_high * square});
    return std::sqrt((beside * beside + off * off) / square);
}

std::array<Position, 4> corners_of(const Box& box) {
    const auto at = [&box](double s, double n) {
        return box.origin + s * box.axis + n * left_of(box.axis);
    };
    return {at(box.along_low, box.across_low), at(box.along_high, box.across_low),
            at(box.along_high, box.across_high), at(box.along_low, box.across_high)};
}

bool overlap(const Box& a, const Box& b, double reach_m) {
    return !separates(a, b, reach_m) && !separates(b, a, reach_m);
}

}  // namespace touchline
