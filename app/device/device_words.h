// What is said about the device to the person at the handle: one thing to do at a time. Sentence by
// sentence it is in the catalogue of words too, but for those with a number.
// Threads: pure functions.
#pragma once

#include "haptics/device/board_frame.h"
#include "haptics/device/homing.h"
#include "haptics/device/nudge_test.h"
#include "haptics/pantograph/profile.h"

#include <string>

namespace touchline {

/// What to do now, after what was noticed if anything was. To be said whenever step or remark
/// change.
[[nodiscard]] std::string words_of(const HomingView& view, const DeviceProfile& profile);

/// What the motors did, and what to do about it; which plug, where one is wrong.
[[nodiscard]] std::string words_of(NudgeVerdict verdict, const BoardFrame& frame);

}  // namespace touchline
