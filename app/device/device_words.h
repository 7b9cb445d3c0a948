// What is said about the device to the person at the handle: one thing to do at a time.
// Threads: pure functions.
#pragma once

#include "haptics/device/homing.h"
#include "haptics/device/nudge_test.h"
#include "haptics/pantograph/profile.h"

#include <string>

namespace touchline {

/// What to do now, after what was noticed if anything was. To be said whenever step or remark
/// change.
[[nodiscard]] std::string words_of(const HomingView& view, const DeviceProfile& profile);

/// What the motors did, and what to do about it.
[[nodiscard]] std::string words_of(NudgeVerdict verdict);

}  // namespace touchline
