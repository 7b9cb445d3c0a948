// How a scene is built from a map. Kiosk, servo, tours and replays share this rule, so that what
// they feel is the same, bit for bit.
// Threads: values and pure functions.
#pragma once

#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "haptics/collision/scene.h"
#include "haptics/pantograph/profile.h"

#include <cstdint>

namespace touchline {

/// Flat, because it crosses between processes.
struct SceneOrder {
    double device_step_m = 1e-4;  // 1e-7 ... 0.01
    double radius_m = 0.0;        // 0 ... 0.02
    std::uint32_t resample = 0;   // 0 or 1
    std::int32_t detail = 0;      // the map's detail, for the black box; 0: unknown
};

/// The order for the kiosk's pictures.
[[nodiscard]] SceneOrder felt_order(const DeviceProfile& profile, int detail = 0);

/// Fails if the order is out of range, and as build_scene() of haptics/collision. O(N log N).
[[nodiscard]] Result<Scene> build_scene(const TactileMap& map, const SceneOrder& order);

}  // namespace touchline
