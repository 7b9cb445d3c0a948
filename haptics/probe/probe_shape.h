// A rigid shape in the hand: straight edges as thin as the lines of a scene, rounded by a radius,
// with a small tree over them. Threads: immutable once built; any thread may read.
#pragma once

#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "haptics/collision/capsule.h"
#include "haptics/curve/segment.h"

#include <cstdint>
#include <span>
#include <vector>

namespace touchline {

inline constexpr std::size_t most_probe_edges = 4096;
inline constexpr double largest_probe_m = 0.1;  // of a point from the origin

/// A part of a shape's edges, inside a capsule in the shape's frame.
struct ProbeNode {
    Capsule capsule;
    std::int32_t left = -1;  // child; the right one is left + 1. -1: a leaf
    std::int32_t edge = -1;  // of a leaf
};

class ProbeShape {
  public:
    /// Takes edges and radius in metres, about the point that the hand holds. Fails, with a line
    /// that says why, if there is no edge, more than 4096 edges, a point that is not finite or
    /// further than 0.1 m from the origin, or a radius outside 0 ... 0.02 m.
    [[nodiscard]] static Result<ProbeShape> build(std::vector<Segment> edges, double radius_m);

    /// Makes a shape of all outlines of a map; the hand holds the middle of the drawing area.
    [[nodiscard]] static Result<ProbeShape> of_map(const TactileMap& map, double radius_m);

    [[nodiscard]] std::span<const Segment> edges() const { return edges_; }

    /// The tree's nodes; the first is the root.
    [[nodiscard]] std::span<const ProbeNode> nodes() const { return nodes_; }

    /// The rounding radius of every edge.
    [[nodiscard]] double radius_m() const { return radius_m_; }

    /// The largest distance of a point of the edges from the origin.
    [[nodiscard]] double r_max_m() const { return r_max_m_; }

  private:
    void split(std::size_t node, std::size_t first, std::size_t last);

    std::vector<Segment> edges_;
    std::vector<ProbeNode> nodes_;
    double radius_m_ = 0.0;
    double r_max_m_ = 0.0;
};

/// Ready shapes, in metres, as polylines like any other outline.
namespace probes {

/// A point with a radius. It is round, so it feels no torque.
[[nodiscard]] ProbeShape disc(double radius_m);

/// A rectangle about its centre.
[[nodiscard]] Outline bar(double length_m, double width_m);

/// Two legs of equal width, with their outer corner at the origin.
[[nodiscard]] Outline ell(double leg_m, double width_m);

/// A bow (a polygon), a shank to the right, and a bit with two teeth at its end; the bow is at the
/// origin.
[[nodiscard]] Outline key(double length_m);

/// The edges of an outline.
[[nodiscard]] std::vector<Segment> edges_of(const Outline& outline);

}  // namespace probes

}  // namespace touchline
