#include "haptics/collision/box.h"

#include <limits>

namespace touchline {
namespace {

/// True when all corners lie further than `reach_m` outside one side of the box.
bool separates(const Box& box, const std::array<Position, 4>& corners, double reach_m) {
    constexpr double far = std::numeric_limits<double>::infinity();
    double s_low = far;
    double s_high = -far;
    double n_low = far;
    double n_high = -far;
    for (const Position c : corners) {
        const double s = dot(box.axis, c - box.origin);
        const double n = cross(box.axis, c - box.origin);
        s_low = std::min(s_low, s);
        s_high = std::max(s_high, s);
        n_low = std::min(n_low, n);
        n_high = std::max(n_high, n);
    }
    const double square = dot(box.axis, box.axis);
    const double grow = reach_m * length_bound(box.axis);
    return (s_low > box.along_high * square + grow) | (s_high < box.along_low * square - grow) |
           (n_low > box.across_high * square + grow) | (n_high < box.across_low * square - grow);
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
    return !separates(a, corners_of(b), reach_m) && !separates(b, corners_of(a), reach_m);
}

}  // namespace touchline
