// Whether the motors have power and pull the right way: short pulses of each motor, and a look at
// what the arms did. The power switch of the adaptor is invisible to USB; without this test a
// person meets walls that are not there. Threads: plain values, one thread.
#pragma once

#include "config/types/vec2.h"
#include "haptics/device/stillness.h"

#include <array>
#include <cstdint>
#include <optional>

namespace touchline {

enum class NudgeVerdict : std::uint8_t {
    running,
    works,
    no_power,     // nothing moves: the motors' switch or adaptor
    motor_1_off,  // only the other one moves
    motor_2_off,
    reversed,  // an arm goes the other way
    swapped,   // the arms answer for each other: motors or encoders
    restless,  // the handle is moved by a hand, or much too fast: let go and try again
    silent,    // the board does not answer
};

class NudgeTest {
  public:
    /// quantum (rad): of one encoder count; a motion of two counts is one.
    explicit NudgeTest(JointAngles quantum);

    /// One tick of dt_s later: angles after calibration, nothing when the board does not answer.
    /// The torques to write now: at most 0.03 Nm, one motor at a time, for 80 ms or until
    /// an arm has moved by a degree; zero once the
    /// verdict has fallen or anything is in doubt. O(1), no allocation.
    [[nodiscard]] JointTorques step(const std::optional<JointAngles>& angles, double dt_s);

    [[nodiscard]] NudgeVerdict verdict() const { return verdict_; }

  private:
    enum class Answer : std::uint8_t { none, right, reversed, other, unclear };
    static constexpr int pulses = 4;  // of motor 1 up and down, then of motor 2

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
    bool is_pulling_ = false;  // else waiting for rest
    double since_s_ = 0.0;
    double silent_s_ = 0.0;
    std::optional<JointAngles> last_;
    JointAngles started_at_;
    std::array<Answer, pulses> answers_{};
};

}  // namespace touchline
