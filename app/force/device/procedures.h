// Homing and the test of the motors, with a device and a person: a thousand ticks a second, and
// words when there is something to do. A board needs both before its first force; motors with
// controllers of their own know where they are and need the test. Threads: one; calls wait until
// they are done.
#pragma once

#include "config/types/calibration.h"
#include "config/types/result.h"
#include "haptics/device/board/pantograph_board.h"
#include "haptics/device/drives/motor_pantograph.h"
#include "haptics/device/nudge_test.h"
#include "haptics/servo/real_time.h"

#include <functional>
#include <string>

namespace touchline {

template <class Device>
struct ProcedureOf {
    Device& board;
    Clock& clock;
    std::function<bool()> goes_on;                // called each tick; false: stop
    std::function<void(const std::string&)> say;  // a line for the person
    double longest_s = 300.0;                     // for each of home(), try_motors() and nudge()
    /// Called with true before a torque is asked of the board, with false once it holds zero again.
    std::function<void(bool)> mark_force = [](bool) {};
};

using Procedure = ProcedureOf<PantographBoard>;
using MotorsProcedure = ProcedureOf<MotorPantograph>;

struct Homed {
    Calibration unit;
    bool is_new = false;  // measured just now
    std::string words;    // says that this is done; comes before the next words
};

/// Leads the person through homing. From here on the board is driven with what was found; the
/// handle rests at the second stop. Fails if it is stopped, out of time, or the board is lost.
[[nodiscard]] Result<Homed> home(const Procedure& procedure, const Calibration& stored);

/// Asks the person to let go of the handle in the middle of its reach and twitches it, until both
/// motors have moved it the way they pushed. No force may come before. With `may_learn`, a wrong
/// verdict corrects the motor plugs once, and the test runs again. Otherwise it names a motor that
/// is wrong, and nothing moves until the procedure ends. Returns the calibration that the board is
/// driven with from here on. `before` is said before the first words. Fails as home() does.
[[nodiscard]] Result<Calibration> try_motors(const Procedure& procedure, bool may_learn,
                                             std::string before = {});

/// The same for motors with controllers of their own, which learn nothing: a wrong verdict fails,
/// and says what was set up wrong.
[[nodiscard]] Result<void> try_motors(const MotorsProcedure& procedure);

/// Both of the first two: what a board needs before its first force. Learns the motors if homing
/// has just measured the unit.
[[nodiscard]] Result<Calibration> make_ready(const Procedure& procedure, const Calibration& stored);

/// After homing, asks the person to let go of the handle in the middle and twitches it once. Fails
/// as home() does.
[[nodiscard]] Result<NudgeTest> nudge(const Procedure& procedure, const std::string& before = {});

}  // namespace touchline
