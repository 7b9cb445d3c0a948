// The scene of a map that came over the socket. Checks every number of the map, then builds it.
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

/// Builds the scene of a message of the kind scene. Fails with one line if its memory is not
/// sealed, is over 64 MiB, or holds no map that can be felt. O(N log N).
[[nodiscard]] Result<BuiltScene> scene_of(const Arrival& arrival);

}  // namespace touchline
