#include "vision/face/slit_rings.h"

#include "vision/contour/sampling.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace touchline {
namespace {

constexpr int kParts = 48;  // of each side, which is some 10 to 20 mm long

/// The two sides of a ring, from its first corner to its second, each in the same number of parts.
struct RingSides {
    std::vector<EdgePoint> upper;
    std::vector<EdgePoint> lower;

    [[nodiscard]] cv::Point2d middle(std::size_t i) const {
        return 0.5 * (upper[i].at + lower[i].at);
    }
};

/// Returns nothing for a ring without two corners, or for a line that is not a ring.
std::optional<RingSides> sides_of(const Chain& ring) {
    if (!ring.is_closed || std::ranges::count(ring.points, true, &EdgePoint::is_fixed) != 2)
        return std::nullopt;
    std::vector<EdgePoint> points = ring.points;
    std::ranges::rotate(points, std::ranges::find(points, true, &EdgePoint::is_fixed));
    const auto corner =
        std::ranges::find(points.begin() + 1, points.end(), true, &EdgePoint::is_fixed);
    const std::vector<EdgePoint> upper(points.begin(), corner + 1);
    std::vector<EdgePoint> lower(corner, points.end());
    lower.push_back(points.front());
    std::ranges::reverse(lower);
    return RingSides{evenly_spaced(upper, kParts), evenly_spaced(lower, kParts)};
}

/// Returns the ring with its sides `factor` times as far apart.
Chain widened(const RingSides& sides, double factor) {
    Chain ring{{}, true};
    const std::size_t last = sides.upper.size() - 1;
    const auto add = [&](const EdgePoint& p, std::size_t i, bool is_corner) {
        const cv::Point2d middle = sides.middle(i);
        ring.points.push_back({middle + factor * (p.at - middle), 0.0, is_corner});
    };
    for (std::size_t i = 0; i <= last; ++i) add(sides.upper[i], i, i == 0 || i == last);
    for (std::size_t i = last - 1; i > 0; --i) add(sides.lower[i], i, false);
    return ring;
}

}  // namespace

Chain middle_of(const Chain& ring) {
    const auto sides = sides_of(ring);
    if (!sides) return ring;
    Chain line;
    for (std::size_t i = 0; i < sides->upper.size(); ++i) {
        line.points.push_back({sides->middle(i)});
    }
    return line;
}

Chain opened_for_finger(const Chain& ring, const SpacingScale& scale) {
    constexpr double kLeastOpening_mm = 3.6;
    constexpr double kMostOpening_mm = 6.0;
    const auto sides = sides_of(ring);
    if (!sides) return ring;
    double opening_mm = 0.0;
    for (std::size_t i = 0; i < sides->upper.size(); ++i) {
        opening_mm = std::max(opening_mm, distance(sides->upper[i].at, sides->lower[i].at));
    }
    if (!(opening_mm > 0.0)) return ring;
    double wanted_mm = std::max(kLeastOpening_mm, opening_mm);
    Chain opened = widened(*sides, wanted_mm / opening_mm);
    while (wanted_mm < kMostOpening_mm && too_near_itself(opened, scale)) {
        wanted_mm += scale.step_mm;
        opened = widened(*sides, wanted_mm / opening_mm);
    }
    return opened;
}

}  // namespace touchline
