#include "haptics/collision/scene.h"

namespace touchline {

Result<Scene> build_scene(const TactileMap& map, const CurveOptions& options, double radius_m) {
    return CurveSet::build(map, options).map([&](CurveSet curves) {
        CollisionTree tree = CollisionTree::build(curves, radius_m);
        return Scene{std::move(curves), std::move(tree), map.area, map.version};
    });
}

}  // namespace touchline
