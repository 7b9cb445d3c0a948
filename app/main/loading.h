// From a file name to what the servo feels and the screen shows, off both of their threads.
// Threads: any, each call by itself.
#pragma once

#include "app/screen/kiosk_screen.h"
#include "app/servo/servo_client.h"
#include "app/session/session.h"
#include "config/types/result.h"
#include "haptics/pantograph/profile.h"

#include <string>

namespace touchline {

struct LoadedScene {
    ShownScene shown;
    FeltPicture felt;
    LoadedFacts facts;
};

/// Reads, traces, and builds the scene for the device. Errors start with the path.
[[nodiscard]] Result<LoadedScene> load_scene(const std::string& path, int detail,
                                             const DeviceProfile& profile);

}  // namespace touchline
