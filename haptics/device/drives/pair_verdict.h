// What every pair of controllers concludes in the same way, whatever its wire: whether it may work,
// what its trouble is, and whether both confirmed that they hold zero torque or let their motors
// go. The pair counts its messages here, and says which of them was answered how.
#pragma once

#include "haptics/device/asked_times.h"
#include "haptics/device/drives/motor_pair.h"

#include <cstdint>
#include <optional>

namespace touchline {

/// Messages to both controllers are numbered from 1. Threads: a plain value. O(1).
class PairVerdict {
  public:
    /// elapsed_s >= 0 passed; what came before is no news any more.
    void step(double elapsed_s);

    /// Begins anew: no trouble is known and nobody wants the motors let go.
    void set_up();

    /// Both are armed and follow.
    void be_ready();

    void go_astray() { state_ = PairState::astray; }

    void lose() { state_ = PairState::gone; }

    /// Astray at the first doubt since the pair was ready, refused at the second: a line that was
    /// lost or garbled reads back like a controller that cannot, but twice is no accident.
    void doubt(const MotorTrouble& trouble);

    void refuse(const MotorTrouble& trouble);

    /// The motors are wanted let go: what was confirmed before does not count.
    void let_go() { let_go_since_ = told_ + 1; }

    /// Counts a message and returns its number. `has_torque`: it asks for a torque that is not
    /// zero.
    std::uint64_t tell(bool has_torque);

    /// Both answered this message, or one after it, that they hold no torque.
    void hear_zero(std::uint64_t number) { held_zero_ = number; }

    /// Both answered this message that their motors are let go.
    void hear_let_go(std::uint64_t number) { let_go_ = number; }

    /// Both answered this message with these turns.
    void hear_turns(std::uint64_t number, ShaftTurns turns);

    /// Something came that was no answer.
    void hear_wrong() { ++wrong_; }

    [[nodiscard]] PairState state() const { return state_; }

    [[nodiscard]] bool is_held_zero() const { return held_zero_ >= zero_since_; }

    /// True if arming may clear a fault that nobody was told of: the pair was not ready yet since
    /// it was made, or since somebody was told of a trouble.
    [[nodiscard]] bool may_clear() const { return may_clear_; }

    [[nodiscard]] PairNews news() const;

    /// What is wrong. Without a better reason, motor `silent` (0: nobody knows which) does not
    /// answer.
    [[nodiscard]] MotorTrouble trouble(int silent) const;

  private:
    PairState state_ = PairState::setting_up;
    MotorTrouble trouble_;
    int doubts_ = 0;  // since the pair was ready
    bool may_clear_ = true;
    double now_s_ = 0.0;
    std::optional<ShaftTurns> turns_;  // of this step
    double late_s_ = 0.0;
    AskedTimes told_at_;
    std::uint64_t told_ = 0;
    std::uint64_t zero_since_ = 1;               // first message after which none had torque
    std::uint64_t held_zero_ = 0;                // newest at which both had none
    std::optional<std::uint64_t> let_go_since_;  // first message that was to let the motors go
    std::uint64_t let_go_ = 0;                   // newest at which both were let go
    std::uint64_t wrong_ = 0;
};

}  // namespace touchline
