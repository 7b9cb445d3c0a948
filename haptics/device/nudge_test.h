// Tests whether the motors have power and push the handle the way they are told, by short pulses of
// each motor and a look at what the arms did. USB shows neither the adaptor's power switch nor the
// motor plugs: without this test a person meets walls that are missing, or that pull. The test
// needs a handle that nobody holds, where both arms can turn both ways: a motor that moves nothing,
// or not twice, proves nothing. Threads: plain values, one thread.
#pragma once

#include "config/types/calibration.h"
#include "config/types/vec2.h"
#include "haptics/device/homing.h"

#include <array>
#include <cstdint>
#include <optional>

namespace touchline {

enum class NudgeVerdict : std::uint8_t {
    running,
    works,
    no_power,     // nothing moves: the motors' switch or adaptor is off, or a hand holds the handle
    motor_1_off,  // only the other motor moves
    motor_2_off,
    reversed_1,     // joint 1's arm goes the other way
    reversed_2,     // joint 2's arm does
    reversed_both,  // both arms do
    swapped,        // the arms answer for each other
    restless,       // the handle is held, moved by a hand, or much too fast: let go and try again
    silent,         // the board does not answer
};

/// True if a motor twice moved the handle differently than it was told: no force may come.
[[nodiscard]] constexpr bool is_wrong(NudgeVerdict verdict) {
    return verdict >= NudgeVerdict::reversed_1 && verdict <= NudgeVerdict::swapped;
}

class NudgeTest {
  public:
    /// quantum (rad): one encoder count; a motion of two counts is one.
    explicit NudgeTest(JointAngles quantum);

    /// Advances one tick of dt_s with calibrated angles, or nothing if the board does not answer.
    /// Returns the torques to write now: at most 0.03 Nm, one motor at a time, for 80 ms or until
    /// an arm has moved by a degree; zero once there is a verdict or anything is in doubt. O(1), no
    /// allocation.
    [[nodiscard]] JointTorques step(const std::optional<JointAngles>& angles, double dt_s);

    [[nodiscard]] NudgeVerdict verdict() const { return verdict_; }

    /// Returns how the motors are really plugged if the test ran with them as `taken`; for a
    /// verdict that is wrong.
    [[nodiscard]] Plugs motors(const Plugs& taken) const;

  private:
    /// Which arm answered a motor: its own or the other joint's, this way or the other.
    enum class Answer : std::uint8_t { none, right, reversed, other, other_reversed, unclear };
    static constexpr int pulses = 4;  // up and down with motor 1, then with motor 2

    JointTorques rest(JointAngles angles, double dt_s);
    JointTorques pull(JointAngles angles);
    JointTorques end(NudgeVerdict verdict);
    [[nodiscard]] Answer judge(JointAngles turn) const;
    [[nodiscard]] Answer answer_of(int motor) const;
    [[nodiscard]] NudgeVerdict decide() const;

    JointAngles quantum_;
    Stillness stillness_;
    NudgeVerdict verdict_ = NudgeVerdict::running;
    int pulse_ = 0;
    bool is_pulling_ = false;  // false: waiting for rest
    double since_s_ = 0.0;
    double silent_s_ = 0.0;
    std::optional<JointAngles> last_;
    JointAngles started_at_;
    std::array<Answer, pulses> answers_{};
};

}  // namespace touchline
