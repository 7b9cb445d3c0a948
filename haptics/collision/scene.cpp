#include "haptics/collision/scene.h"

#include "haptics/collision/crowding.h"
#include "haptics/collision/safe_levels.h"
#include "haptics/curve/level_error.h"

namespace touchline {
namespace {

constexpr int most_builds = 2;  // pins move what is unsafe; what is left after that loses levels

Scene scene_of(CurveSet curves, CollisionTree tree, const TactileMap& map) {
    const int percept = percept_level(curves);
    std::vector<Leg> legs = legs_of(curves, tree, map.labels);
    return {std::move(curves), std::move(tree), map.area, map.version, percept, std::move(legs)};
}

}  // namespace

Result<Scene> build_scene(const TactileMap& map, const CurveOptions& options, double radius_m) {
    CurveOptions wanted = options;
    for (int build = 1;; ++build) {
        Result<CurveSet> curves = CurveSet::build(map, wanted);
        if (!curves) return tl::unexpected(std::move(curves.error()));
        CollisionTree tree = CollisionTree::build(*curves, radius_m);
        Meetings meetings = Crowding(tree, *curves, contact_skin_m).find_meetings();
        const bool is_complete = meetings.is_complete;
        const SafeLevels safe = find_safe_levels(*curves, std::move(meetings));
        const auto pins = build < most_builds ? pins_for(*curves, safe) : std::vector<PinPlace>{};
        if (!pins.empty()) {
            wanted.pins.insert(wanted.pins.end(), pins.begin(), pins.end());
            continue;
        }
        // Which nodes are alone depends on the levels that exist.
        const bool is_limited = !safe.unsafe.empty() || !is_complete;
        curves->limit_levels(safe.coarsest);
        if (is_limited) tree = CollisionTree::build(*curves, radius_m);
        return scene_of(std::move(*curves), std::move(tree), map);
    }
}

}  // namespace touchline
