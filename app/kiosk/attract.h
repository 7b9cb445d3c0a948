// What the screen shows while nobody is here: a picture that a hand feels.
// Threads: pure functions.
#pragma once

#include "app/screen/screen_content.h"
#include "config/types/hand_state.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "haptics/curve/segment.h"

#include <vector>

namespace touchline {

/// A picture, and the longest of its lines as a hand follows it.
struct AttractPicture {
    ShownScene shown;
    std::vector<Segment> line;
    double length_m = 0.0;  // of the line
};

/// Its lines as a hand feels them. Fails as build_scene(). O(segments of the map).
[[nodiscard]] Result<AttractPicture> attract_picture(const TactileMap& map);

/// A hand that follows the line for ever, `now_s` after it began, a step a second; at rest
/// without a line. O(segments of the line).
[[nodiscard]] HandState attract_hand(const AttractPicture& picture, double now_s);

}  // namespace touchline
