// Homing and the test of the motors with a board and a person: a thousand ticks a second, words
// when something is to be done. What stands between a board and its first force. Threads: one;
// calls wait until they are done.
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
    double longest_s = 300.0;                     // each of home(), try_motors() and nudge()
    /// True before a torque is asked of the board, false once it holds zero again.
    std::function<void(bool)> mark_force = [](bool) {};
};

struct Homed {
    Calibration unit;
    bool is_new = false;  // it was measured just now
    std::string words;    // that this is done, to be said before what comes next
};

/// Leads the person through homing. The board is driven with what was found from here on, the
/// handle at rest at the second stop. Fails when stopped, out of time, or the board is lost.
[[nodiscard]] Result<Homed> home(const Procedure& procedure, const Calibration& stored);

/// Has the handle let go of in the middle of its reach and twitches it, again and again until both
/// motors have moved it the way they pushed; no force may come before. With `may_learn`, a wrong
/// verdict corrects the motor plugs once, and the test runs again. Else a motor that is wrong is
/// told, and nothing moves any more until the procedure ends. What the board is driven with from
/// here on. `before` is said before the first words. Fails as home() does.
[[nodiscard]] Result<Calibration> try_motors(const Procedure& procedure, bool may_learn,
                                             std::string before = {});

/// Both of the above: what a board must have been through before its first force. Its motors are
/// learnt where homing has just measured the unit.
[[nodiscard]] Result<Calibration> make_ready(const Procedure& procedure, const Calibration& stored);

/// Has the handle let go of in the middle, once it was homed, and twitches it once. Fails as home()
/// does.
[[nodiscard]] Result<NudgeTest> nudge(const Procedure& procedure, const std::string& before = {});

}  // namespace touchline
