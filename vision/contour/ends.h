// The ends of lines, and how to find what is near them.
// Threads: values.
#pragma once

#include "vision/contour/chain.h"

#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace touchline {

/// One end of an open chain: 2 x chain index, + 1 for its back.
using EndId = std::size_t;

[[nodiscard]] constexpr EndId front_of(std::size_t chain) {
    return 2 * chain;
}

[[nodiscard]] constexpr EndId back_of(std::size_t chain) {
    return 2 * chain + 1;
}

[[nodiscard]] constexpr std::size_t chain_of(EndId end) {
    return end / 2;
}

[[nodiscard]] constexpr bool is_back(EndId end) {
    return end % 2 == 1;
}

/// A point as a key: the arms of a junction share theirs, bit for bit.
using Place = std::pair<double, double>;

[[nodiscard]] inline Place place_of(const cv::Point2d& p) {
    return {p.x, p.y};
}

/// The straight continuation of a line beyond an end.
struct Ray {
    cv::Point2d from;
    cv::Point2d direction;  // unit vector, outward
};

/// Returns the direction of the line near an end, from its points between `skip_px` and `skip_px +
/// span_px` of arc length from the end (fewer on a short line); `from` is the first of them.
[[nodiscard]] Ray ray_at(const std::vector<EdgePoint>& line, bool at_back, double skip_px,
                         double span_px);

/// Returns the angle between two directions, 0 to pi.
[[nodiscard]] double angle_between(const cv::Point2d& a, const cv::Point2d& b);

/// Returns the angle by which a line coming along the one ray turns to leave along the other, 0 to
/// pi.
[[nodiscard]] double turn(const Ray& in, const Ray& out);

/// A line that turns by less than this, in radians, goes straight on.
inline constexpr double kStraightOn = 30.0 * std::numbers::pi / 180.0;

/// Returns the least-squares crossing of the lines along some rays; nothing if the determinant is
/// below `least`. For two rays it is the square of the sine between them.
[[nodiscard]] std::optional<cv::Point2d> crossing_of(const std::vector<Ray>& rays, double least);

/// The place of a point in a list of chains.
struct PointRef {
    std::size_t chain = 0;
    std::size_t index = 0;
};

/// All points of some chains in square cells, for range queries. Holds no reference to the chains.
class PointGrid {
  public:
    /// cell_px > 0 should be about the radius of the queries.
    PointGrid(const std::vector<Chain>& chains, cv::Size picture, double cell_px);

    /// Visits the points in the cells that the disc touches: a superset of those within the radius.
    template <class Visit>
    void near(const cv::Point2d& centre, double radius_px, Visit&& visit) const {
        const int left = column(centre.x - radius_px);
        const int right = column(centre.x + radius_px);
        for (int r = row(centre.y - radius_px); r <= row(centre.y + radius_px); ++r) {
            const auto first = static_cast<std::size_t>(r * columns_ + left);
            const auto last = static_cast<std::size_t>(r * columns_ + right);
            for (std::size_t i = start_[first]; i < start_[last + 1]; ++i) {
                visit(refs_[i]);
            }
        }
    }

  private:
    [[nodiscard]] int column(double x) const;
    [[nodiscard]] int row(double y) const;
    [[nodiscard]] std::size_t cell_of(const cv::Point2d& p) const;

    double cell_px_;
    int columns_;
    int rows_;
    std::vector<std::size_t> start_;  // of each cell in refs_, one more at the end
    std::vector<PointRef> refs_;
};

}  // namespace touchline
