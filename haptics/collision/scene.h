// What the servo feels: a map's curves, the collision tree over them, and the way along the
// outlines for a guided hand: level 0 in the map's order, cut where the hand is to rest. Threads:
// immutable once built (off the tick); any thread may read.
#pragma once

#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "haptics/collision/collision_tree.h"
#include "haptics/curve/curve_set.h"

#include <cstdint>
#include <span>
#include <vector>

namespace touchline {

/// A part of a piece's level-0 polyline, from point `first` to point `last` > first. In a closed
/// piece of n points, point n is point 0.
struct Leg {
    int outline = 0;  // index in the map
    int piece = 0;
    int first = 0;
    int last = 0;
    bool starts_outline = false;
    bool rests_at_end = false;  // a corner, a junction, a label or the outline's end
    int label = -1;             // map label at its end; -1: none
    double run_m = 0.0;         // from its start to the next resting place
};

/// Cuts the outlines into legs. A label counts if an outline passes within 10 mm of it; the hand
/// rests at the vertex nearest to it. O((points + labels) log).
[[nodiscard]] std::vector<Leg> legs_of(const CurveSet& curves, const CollisionTree& tree,
                                       std::span<const Label> labels);

struct Scene {
    CurveSet curves;
    CollisionTree tree;
    Area area;
    std::uint64_t map_version = 0;
    int percept_level = 0;  // curve level (level_error.h) from which no finer one can be told apart
    std::vector<Leg> legs = {};  // of all outlines, in the map's order
    std::uint64_t drawing = 0;   // as the map's
};

/// O(N log N). `radius_m` >= 0 is the largest proxy radius that will be used on this scene; it
/// decides which segments are crowded (see collision_tree.h).
[[nodiscard]] Result<Scene> build_scene(const TactileMap& map, const CurveOptions& options,
                                        double radius_m);

}  // namespace touchline
