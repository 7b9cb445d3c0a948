// The scene of a map that came over the socket: checked to the last number, then built.
// Threads: a pure function of what arrived.
#pragma once

#include "app/servo/messages.h"
#include "config/types/result.h"
#include "haptics/collision/scene.h"
#include "haptics/servo/recording.h"

#include <memory>

namespace touchline {

struct BuiltScene {
    std::shared_ptr<const Scene> scene;
    RecordedMap recorded;
};

/// Of a message of the kind scene. One line where its memory is not sealed, over 64 MiB, or no map
/// that can be felt. O(N log N).
[[nodiscard]] Result<BuiltScene> scene_of(const Arrival& arrival);

}  // namespace touchline
