// Whether the motors have power and push the handle the way they are told: short pulses of each
// motor, and a look at what the arms did. The power switch of the adaptor is invisible to USB, and
// so are plugs: without this test a person meets walls that are not there, or that pull. For a
// handle that nobody holds, where both arms can turn both ways: a motor that moves nothing, or not
// twice, proves nothing. Threads: plain values, one thread.
#pragma once

#include "config/types/calibration.h"
#include "config/types/vec2.h"
#include "haptics/device/stillness.h"

#include <array>
#include <cstdint>
#include <optional>

namespace touchline {

enum class NudgeVerdict : std::uint8_t {
    running,
    works,
    no_power,     // nothing moves: the motors' switch or adaptor, or a hand that holds
    motor_1_off,  // only the other one moves
    motor_2_off,
    reversed_1,     // the arm of joint 1 goes the other way
    reversed_2,     // that of joint 2
    reversed_both,  // both
    swapped,        // the arms answer for each other
    restless,       // the handle is held, moved by a hand, or much too fast: let go and try again
    silent,         // the board does not answer
};

/// A motor moved the handle otherwise than it was told, twice: no force may come.
[[nodiscard]] constexpr bool is_wrong(NudgeVerdict verdict) {
    return verdict >= NudgeVerdict::reversed_1 && verdict <= NudgeVerdict::swapped;
}

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

    /// What the motors must be taken for that were taken for `taken` during the test; for a verdict
    /// that is wrong.
    [[nodiscard]] Plugs motors(const Plugs& taken) const;

  private:
    /// Of an arm to a motor: its own, or that of the other joint, this way or the other.
    enum class Answer : std::uint8_t { none, right, reversed, other, other_reversed, unclear };
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
