#include "haptics/collision/scene.h"

#include "haptics/curve/level_error.h"

namespace touchline {

Result<Scene> build_scene(const TactileMap& map, const CurveOptions& options, double radius_m) {
    return CurveSet::build(map, options).map([&](CurveSet curves) {
        CollisionTree tree = CollisionTree::build(curves, radius_m);
        const int percept = percept_level(curves);
        return Scene{std::move(curves), std::move(tree), map.area, map.version, percept};
    });
}

}  // namespace touchline
