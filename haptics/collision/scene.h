// What the servo feels: a map's curves and the collision tree over them.
// Threads: immutable once built (off the tick); any thread may read.
#pragma once

#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "haptics/collision/collision_tree.h"
#include "haptics/collision/legs.h"
#include "haptics/curve/curve_set.h"

#include <cstdint>
#include <vector>

namespace touchline {

struct Scene {
    CurveSet curves;
    CollisionTree tree;
    Area area;
    std::uint64_t map_version = 0;
    int percept_level = 0;  // curve level (level_error.h) from which no finer one can be told apart
    std::vector<Leg> legs = {};  // of all outlines, in the map's order
};

/// O(N log N). `radius_m` >= 0 is the largest proxy radius that will be used on this scene; it
/// decides which segments are crowded (see collision_tree.h).
[[nodiscard]] Result<Scene> build_scene(const TactileMap& map, const CurveOptions& options,
                                        double radius_m);

}  // namespace touchline
