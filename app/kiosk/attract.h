// What the screen shows while nobody is here: a picture that a hand feels.
// Threads: pure functions.
#pragma once

#include "app/screen/screen_content.h"
#include "config/types/hand_state.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

namespace touchline {

/// Its lines as a hand feels them. Fails as build_scene().
[[nodiscard]] Result<ShownScene> attract_scene(const TactileMap& map);

/// A hand that follows the longest line of the scene for ever, `now_s` after it began. O(segments
/// of the line).
[[nodiscard]] HandState attract_hand(const Scene& scene, double now_s);

}  // namespace touchline
