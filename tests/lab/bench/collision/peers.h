// The structures of other libraries, each as the benchmark asks it: packed R-tree (Boost.Geometry),
// AABB tree (CGAL), and a whole Box2D scene.
#pragma once

#include "tests/lab/bench/collision/crossing.h"

#include <memory>

namespace touchline::bench {

/// Boost.Geometry's R-tree over the edges.
/// Threads: immutable once built; any thread may query.
class RTree {
  public:
    /// Packed (sort-tile-recursive), 16 values a node. O(N log N). `curve` must outlive the tree.
    explicit RTree(ClosedCurve curve);
    RTree(RTree&&) noexcept;
    RTree(const RTree&) = delete;
    RTree& operator=(RTree&&) = delete;
    RTree& operator=(const RTree&) = delete;
    ~RTree();

    /// Looks at every edge that the library finds on the motion, because it has no ordered walk
    /// along one.
    [[nodiscard]] std::optional<Crossing> first_crossing(Position from, Position to) const;

    [[nodiscard]] Nearest nearest(Position p) const;

  private:
    struct Index;
    ClosedCurve curve_;
    std::unique_ptr<Index> index_;
};

/// CGAL's tree of axis-aligned boxes over the edges, taken as segments in space with z = 0, because
/// this version has no tree for the plane. Threads: immutable once built; any thread may query.
class AabbTree {
  public:
    /// Also builds the search structure that the library wants for nearest points. O(N log N).
    /// `curve` must outlive the tree.
    explicit AabbTree(ClosedCurve curve);
    AabbTree(AabbTree&&) noexcept;
    AabbTree(const AabbTree&) = delete;
    AabbTree& operator=(AabbTree&&) = delete;
    AabbTree& operator=(const AabbTree&) = delete;
    ~AabbTree();

    /// Uses the library's traversal and box test. Cuts the motion at every crossing found, so that
    /// it skips the boxes behind it.
    [[nodiscard]] std::optional<Crossing> first_crossing(Position from, Position to) const;

    [[nodiscard]] Nearest nearest(Position p) const;

  private:
    struct Index;
    ClosedCurve curve_;
    std::unique_ptr<Index> index_;
};

/// Returns the library's unit of length for a curve: 1 mm up to 4096 edges, 0.1 mm up to 65536,
/// otherwise 0.01 mm. The library refuses edges shorter than 0.005 units and moves a body at most 2
/// units a step, so no one unit suits all curves.
[[nodiscard]] double box2d_unit_m(std::size_t edges);

/// Whether the disc can follow a hand at 0.3 m/s: not if a step of 1 ms is capped at 0.02 mm.
[[nodiscard]] bool can_box2d_follow(std::size_t edges);

/// Box2D 2.4: the curve as a one-sided chain, solid inside, and a tool disc of 0.5 mm on a mouse
/// joint. Threads: one.
class Box2dScene {
  public:
    /// Takes counter-clockwise corners: the chain is solid towards the inside.
    explicit Box2dScene(ClosedCurve curve);
    Box2dScene(Box2dScene&&) noexcept;
    Box2dScene(const Box2dScene&) = delete;
    Box2dScene& operator=(Box2dScene&&) = delete;
    Box2dScene& operator=(const Box2dScene&) = delete;
    ~Box2dScene();

    /// Returns the point of the nearest hit of the library's ray cast, from outside only. The
    /// library does not report the edge.
    [[nodiscard]] std::optional<Position> first_crossing(Position from, Position to) const;

    /// Does the whole step of the library: broad phase, contacts, solver (8 and 3 iterations),
    /// continuous collision. The joint has 100 Hz and critical damping. Returns the disc's centre.
    Position step(Position hand);

    void start(Position hand) { reset(hand); }

    /// Places the disc at the hand, at rest.
    void reset(Position hand);

  private:
    struct World;
    double unit_m_;
    std::unique_ptr<World> world_;
};

}  // namespace touchline::bench
