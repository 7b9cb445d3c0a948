// What the person at the handle is told about the device: one thing to do at a time. Each sentence
// is also in the catalogue of words.
// Threads: pure functions.
#pragma once

#include "haptics/device/board/board_frame.h"
#include "haptics/device/homing.h"
#include "haptics/device/nudge_test.h"
#include "haptics/pantograph/profile.h"

#include <string>

namespace touchline {

/// What to do now, after what was noticed, if anything. Say it whenever `prompts` changes.
[[nodiscard]] std::string words_of(const HomingView& view, const DeviceProfile& profile);

/// Says the same in another way, so that it sounds different.
[[nodiscard]] std::string words_again(const std::string& words);

/// Said while the motors are to be tried and the handle is not in the middle.
[[nodiscard]] std::string words_outside_the_middle(const BoardFrame& frame);

/// What the motors did, and what to do about it; if a plug is wrong, which one.
[[nodiscard]] std::string words_of(NudgeVerdict verdict, const BoardFrame& frame);

}  // namespace touchline
