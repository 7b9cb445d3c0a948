// What is said about the device to the person at the handle: one thing to do at a time. Sentence by
// sentence it is in the catalogue of words too.
// Threads: pure functions.
#pragma once

#include "haptics/device/board_frame.h"
#include "haptics/device/homing.h"
#include "haptics/device/nudge_test.h"
#include "haptics/pantograph/profile.h"

#include <string>

namespace touchline {

/// What to do now, after what was noticed if anything was. To be said whenever `prompts`
/// changes.
[[nodiscard]] std::string words_of(const HomingView& view, const DeviceProfile& profile);

/// The same as was said before, so that it sounds otherwise.
[[nodiscard]] std::string words_again(const std::string& words);

/// While the motors are to be tried and the handle is elsewhere.
[[nodiscard]] std::string words_outside_the_middle(const BoardFrame& frame);

/// What the motors did, and what to do about it; which plug, where one is wrong.
[[nodiscard]] std::string words_of(NudgeVerdict verdict, const BoardFrame& frame);

}  // namespace touchline
