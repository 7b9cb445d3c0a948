// Builds the collision tree in two parts: the boxes and the hierarchy over the coarsest segments,
// which say where levels are unsafe; then, once it is settled which levels stay, start grid and
// which nodes are alone. Threads: off the tick.
#pragma once

#include "haptics/collision/collision_tree.h"
#include "haptics/collision/crowding.h"
#include "haptics/curve/curve_set.h"

#include <cstddef>
#include <span>
#include <vector>

namespace touchline {

class CollisionTreeBuilder {
  public:
    /// Bounds all levels. The curves must outlive the builder. O(N).
    explicit CollisionTreeBuilder(const CurveSet& curves);

    /// Returns which nodes come as near as a point's contact skin.
    [[nodiscard]] Meetings find_meetings() const;

    /// Builds the hierarchy anew; call when the levels of the curves were limited.
    void hang();

    /// `radius_m` as for CollisionTree::build().
    [[nodiscard]] CollisionTree finish(double radius_m) &&;

  private:
    struct Root {
        Stretch stretch;
        Shadow shadow;    // x along, y across
        Position middle;  // twice that of its middle node
    };

    void bound_level(int piece, int level);
    void add_stretches(int piece, int level, std::vector<Stretch>& stretches) const;
    void bound_roots(std::size_t at, std::span<Root> roots, std::size_t first);
    [[nodiscard]] Shadow upright_shadow(const Stretch& stretch) const;
    [[nodiscard]] double mean_edge_m() const;
    void lay_grid();

    const CurveSet& curves_;
    CollisionTree tree_;
};

}  // namespace touchline
