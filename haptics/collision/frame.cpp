#include "haptics/collision/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchline {
namespace {

/// Narrows [low, high], the shares of a way spent within one slab. False when nothing is left.
bool clip(double start, double way, double slab_low, double slab_high, double& low, double& high) {
    if (way == 0.0) return start >= slab_low && start <= slab_high;
    double enter = (slab_low - start) / way;
    double leave = (slab_high - start) / way;
    if (enter > leave) std::swap(enter, leave);
    low = std::max(low, enter);
    high = std::min(high, leave);
    return low <= high;
}

/// True when all corners lie outside one side of the box.
bool separates(const AlignedBox& box, const std::array<Position, 4>& corners) {
    constexpr double far = std::numeric_limits<double>::infinity();
    double s_low = far;
    double s_high = -far;
    double n_low = far;
    double n_high = -far;
    for (const Position c : corners) {
        const double s = dot(box.along, c - box.origin);
        const double n = cross(box.along, c - box.origin);
        s_low = std::min(s_low, s);
        s_high = std::max(s_high, s);
        n_low = std::min(n_low, n);
        n_high = std::max(n_high, n);
    }
    return s_low > box.along_high || s_high < box.along_low || n_low > box.across_high ||
           n_high < box.across_low;
}

}  // namespace

std::array<Position, 4> corners_of(const AlignedBox& box) {
    const auto at = [&box](double s, double n) {
        return box.origin + along<Position>(box.along, s) + along<Position>(left_of(box.along), n);
    };
    return {at(box.along_low, box.across_low), at(box.along_high, box.across_low),
            at(box.along_high, box.across_high), at(box.along_low, box.across_high)};
}

AlignedBox grown(AlignedBox box, double by_m) {
    box.along_low -= by_m;
    box.along_high += by_m;
    box.across_low -= by_m;
    box.across_high += by_m;
    return box;
}

std::optional<double> entry(const AlignedBox& box, Position from, Position to) {
    const Position w = from - box.origin;
    const Position way = to - from;
    double low = 0.0;
    double high = 1.0;
    if (!clip(dot(box.along, w), dot(box.along, way), box.along_low, box.along_high, low, high) ||
        !clip(cross(box.along, w), cross(box.along, way), box.across_low, box.across_high, low,
              high)) {
        return {};
    }
    return low;
}

double distance_m(const AlignedBox& box, Position p) {
    const double s = dot(box.along, p - box.origin);
    const double n = cross(box.along, p - box.origin);
    return std::hypot(std::max({0.0, box.along_low - s, s - box.along_high}),
                      std::max({0.0, box.across_low - n, n - box.across_high}));
}

bool overlap(const AlignedBox& a, const AlignedBox& b) {
    return !separates(a, corners_of(b)) && !separates(b, corners_of(a));
}

}  // namespace touchline
