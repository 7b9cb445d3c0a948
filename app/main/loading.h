// From a file name to what the servo feels and the screen shows, off both of their threads.
// Threads: any, each call by itself.
#pragma once

#include "app/screen/kiosk_screen.h"
#include "app/session/session.h"
#include "config/types/result.h"
#include "haptics/servo/recording.h"

#include <string>

namespace touchline {

struct LoadedScene {
    ShownScene shown;
    LoadedFacts facts;
    RecordedMap recorded;
};

/// Reads, traces, and builds the scene. Errors start with the path.
[[nodiscard]] Result<LoadedScene> load_scene(const std::string& path, int detail);

}  // namespace touchline
