// Homing and the nudge test with a board and a person: a thousand ticks a second, words when
// something is to be done.
// Threads: one; calls wait until they are done.
#pragma once

#include "config/types/calibration.h"
#include "config/types/result.h"
#include "haptics/device/nudge_test.h"
#include "haptics/device/pantograph_board.h"
#include "haptics/servo/tick_clock.h"

#include <functional>
#include <optional>
#include <string>

namespace touchline {

struct Procedure {
    PantographBoard& board;
    Clock& clock;
    std::function<bool()> goes_on;                // asked each tick; false: stop
    std::function<void(const std::string&)> say;  // a line for the person
    double longest_s = 300.0;
};

/// Leads the person through homing. The board is driven with what was found from here on, the
/// handle at rest at the second stop. Fails when stopped, out of time, or the board is lost.
[[nodiscard]] Result<Calibration> home(const Procedure& procedure,
                                       const std::optional<Calibration>& stored);

/// Twitches the handle. Fails when stopped.
[[nodiscard]] Result<NudgeVerdict> nudge(const Procedure& procedure);

}  // namespace touchline
