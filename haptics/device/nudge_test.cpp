#include "haptics/device/nudge_test.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double pulse_Nm = 0.03;
constexpr double longest_pulse_s = 0.08;
constexpr double enough_rad = 0.02;  // of motion: the pulse may end
constexpr double enough_counts = 4.0;
constexpr double motion_counts = 2.0;    // more than that is motion
constexpr double still_before_s = 0.05;  // of stillness before a pulse
constexpr double rest_patience_s = 2.0;  // to wait for that stillness
constexpr double silence_limit_s = 0.02;
constexpr double fastest_rad_per_s = 15.0;  // about 1 m/s at the elbow

double sign_of(int pulse) {
    return pulse % 2 == 0 ? 1.0 : -1.0;
}

JointAngles in_counts(JointAngles turn, JointAngles quantum) {
    return {turn.x / quantum.x, turn.y / quantum.y};
}

double largest_of(JointAngles a) {
    return std::max(std::abs(a.x), std::abs(a.y));
}

}  // namespace

NudgeTest::NudgeTest(JointAngles quantum)
    : quantum_(quantum), stillness_(motion_counts * quantum) {}

JointTorques NudgeTest::end(NudgeVerdict verdict) {
    verdict_ = verdict;
    return {};
}

JointTorques NudgeTest::step(const std::optional<JointAngles>& angles, double dt_s) {
    if (verdict_ != NudgeVerdict::running) return {};
    if (!angles || !is_finite(*angles) || !(dt_s > 0.0)) {
        silent_s_ += std::isfinite(dt_s) ? dt_s : silence_limit_s;
        return silent_s_ >= silence_limit_s ? end(NudgeVerdict::silent) : JointTorques{};
    }
    silent_s_ = 0.0;
    since_s_ += dt_s;
    const JointAngles turn = *angles - last_.value_or(*angles);
    last_ = angles;
    const double largest_turn = fastest_rad_per_s * dt_s + 2.0 * largest_of(quantum_);
    if (!(largest_of(turn) <= largest_turn)) return end(NudgeVerdict::restless);
    return is_pulling_ ? pull(*angles) : rest(*angles, dt_s);
}

JointTorques NudgeTest::rest(JointAngles angles, double dt_s) {
    stillness_.step(angles, dt_s);
    if (stillness_.still_s() < still_before_s)
        return since_s_ < rest_patience_s ? JointTorques{} : end(NudgeVerdict::restless);
    started_at_ = angles;
    since_s_ = 0.0;
    is_pulling_ = true;
    return pull(angles);
}

JointTorques NudgeTest::pull(JointAngles angles) {
    const JointAngles turn = angles - started_at_;
    const bool has_moved =
        largest_of(turn) >= enough_rad && largest_of(in_counts(turn, quantum_)) >= enough_counts;
    if (!has_moved && since_s_ < longest_pulse_s) {
        const double torque = sign_of(pulse_) * pulse_Nm;
        return pulse_ < 2 ? JointTorques{torque, 0.0} : JointTorques{0.0, torque};
    }
    answers_[static_cast<std::size_t>(pulse_)] = judge(turn);
    since_s_ = 0.0;
    is_pulling_ = false;
    stillness_.start_again();
    if (++pulse_ == pulses) verdict_ = decide();
    return {};
}

NudgeTest::Answer NudgeTest::judge(JointAngles turn) const {
    const JointAngles counts = in_counts(turn, quantum_);
    const double own = sign_of(pulse_) * (pulse_ < 2 ? counts.x : counts.y);
    const double other = sign_of(pulse_) * (pulse_ < 2 ? counts.y : counts.x);
    if (!(largest_of(counts) > motion_counts)) return Answer::none;
    if (std::abs(other) > std::abs(own))
        return other > 0.0 ? Answer::other : Answer::other_reversed;
    return own > 0.0 ? Answer::right : Answer::reversed;
}

/// Up and down must agree, so that a hand that moves the handle meanwhile is not taken for a motor.
NudgeTest::Answer NudgeTest::answer_of(int motor) const {
    const auto first = static_cast<std::size_t>(2 * motor);
    return answers_[first] == answers_[first + 1] ? answers_[first] : Answer::unclear;
}

NudgeVerdict NudgeTest::decide() const {
    const Answer one = answer_of(0);
    const Answer two = answer_of(1);
    const auto is_other = [](Answer a) {
        return a == Answer::other || a == Answer::other_reversed;
    };
    if (one == Answer::none && two == Answer::none) return NudgeVerdict::no_power;
    if (one == Answer::unclear || two == Answer::unclear) return NudgeVerdict::restless;
    if (one == Answer::none) return NudgeVerdict::motor_1_off;
    if (two == Answer::none) return NudgeVerdict::motor_2_off;
    if (is_other(one) != is_other(two)) return NudgeVerdict::restless;
    if (is_other(one)) return NudgeVerdict::swapped;
    if (one == Answer::reversed)
        return two == Answer::reversed ? NudgeVerdict::reversed_both : NudgeVerdict::reversed_1;
    return two == Answer::reversed ? NudgeVerdict::reversed_2 : NudgeVerdict::works;
}

Plugs NudgeTest::motors(const Plugs& taken) const {
    const auto is_against = [this](int motor) {
        const Answer answer = answer_of(motor);
        return answer == Answer::reversed || answer == Answer::other_reversed;
    };
    const bool is_1_against = taken.is_1_reversed != is_against(0);
    const bool is_2_against = taken.is_2_reversed != is_against(1);
    if (verdict_ != NudgeVerdict::swapped) return {taken.are_swapped, is_1_against, is_2_against};
    return {!taken.are_swapped, is_2_against, is_1_against};
}

}  // namespace touchline
