// Builds the collision tree in two parts: the boxes and the hierarchy over the coarsest segments,
// which say where levels are unsafe; then, once it is settled which levels stay, start grid and
// which nodes are alone. Threads: off the tick.
#pragma once

#include "haptics/collision/collision_tree.h"
#include "haptics/collision/crowding.h"
#include "haptics/curve/curve_set.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace touchline {

/// What was found of pieces that a build from the same CurveSource, with more pins, has again.
struct KnownPieces {
    struct Entry {
        int outline = 0;
        bool is_closed = false;
        std::size_t first_vertex = 0;
        std::size_t last_vertex = 0;
        int edges = 0;              // at level 0
        std::size_t first_box = 0;  // of its own among the extents
    };

    std::vector<Entry> entries;  // in the order of the pieces
    std::vector<PackedExtents> extents;
    Meetings meetings;
};

class CollisionTreeBuilder {
  public:
    /// Bounds all levels. A piece that is known, between the same vertices and with as many edges,
    /// must have the same points: it is neither bounded again nor compared with others of that
    /// kind. The curves must outlive the builder. O(N).
    explicit CollisionTreeBuilder(const CurveSet& curves, KnownPieces known = {});

    /// Returns which nodes come as near as a point's contact skin.
    [[nodiscard]] Meetings find_meetings();

    /// Gives up the boxes for another builder; `meetings` are those found.
    [[nodiscard]] KnownPieces known_pieces(Meetings meetings) &&;

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

    [[nodiscard]] KnownPieces::Entry entry_of(int piece) const;
    [[nodiscard]] std::span<PackedExtents> boxes_of(int piece);
    void bound_level(int piece, int level);
    void add_stretches(int piece, int level, std::vector<Stretch>& stretches) const;
    void bound_roots(std::size_t at, std::span<Root> roots, std::size_t first);
    [[nodiscard]] Shadow upright_shadow(const Stretch& stretch) const;
    [[nodiscard]] double mean_edge_m() const;
    void lay_grid(double reach_m);

    const CurveSet& curves_;
    CollisionTree tree_;
    std::vector<bool> is_known_;                      // per piece
    Meetings known_meetings_;                         // of two known pieces
    std::optional<std::vector<MeetingNodes>> close_;  // as soon as meetings were found
};

}  // namespace touchline
