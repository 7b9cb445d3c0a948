// Finds points of lines that face each other across a narrow stripe, as its two edges do.
// Threads: pure functions.
#pragma once

#include "vision/contour/ends.h"

#include <cmath>
#include <optional>

namespace touchline {

/// What lies between two facing edges.
enum class Stripe { dark, light };

/// The point on the other side of a stripe.
struct Facing {
    PointRef to;
    Stripe stripe = Stripe::dark;
    double width_px = 0.0;
};

/// Returns the stripe between two edge points: they are edges of one if their light sides are
/// opposite (within 30 degrees) and the way over runs across both (within 35 degrees).
[[nodiscard]] std::optional<Stripe> stripe_between(const EdgePoint& p, const EdgePoint& q);

/// Returns the nearest of the chains' points (all in `grid`) that faces `p` at less than
/// `widest_px`; `may_face` chooses among them by PointRef.
template <class MayFace>
std::optional<Facing> facing(const EdgePoint& p, const std::vector<Chain>& chains,
                             const PointGrid& grid, double widest_px, MayFace&& may_face) {
    std::optional<Facing> nearest;
    double least_squared = widest_px * widest_px;
    grid.near(p.at, widest_px, [&](const PointRef& ref) {
        const EdgePoint& q = chains[ref.chain].points[ref.index];
        const cv::Point2d over = q.at - p.at;
        const double squared = over.dot(over);
        if (squared < least_squared && squared > 0.0 && may_face(ref)) {
            if (const std::optional<Stripe> stripe = stripe_between(p, q)) {
                least_squared = squared;
                nearest = Facing{ref, *stripe, std::sqrt(squared)};
            }
        }
    });
    return nearest;
}

/// A line that faces a longer one along more than 70 % of itself, over less than half its length.
struct FacingPair {
    std::size_t shorter = 0;
    std::size_t longer = 0;
    Stripe stripe = Stripe::dark;
    double width_px = 0.0;  // mean
};

/// Returns all such pairs, narrowest first; each point faces the nearest line only.
[[nodiscard]] std::vector<FacingPair> facing_pairs(const std::vector<Chain>& chains,
                                                   cv::Size picture, double widest_px);

/// A ring round a stripe.
struct ThinRing {
    std::size_t tip = 0;  // if begun here, its two halves (by points) are the stripe's sides
    Stripe stripe = Stripe::dark;
    double width_px = 0.0;  // mean
};

/// Returns the ring if its halves face each other along more than 70 % of them, over less than a
/// third of their length.
[[nodiscard]] std::optional<ThinRing> thin_ring(const std::vector<Chain>& chains, std::size_t ring,
                                                const PointGrid& grid, double widest_px);

}  // namespace touchline
