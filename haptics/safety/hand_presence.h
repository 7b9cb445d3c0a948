// Tells whether a hand holds the handle, by how it moves: neither the device's mass alone nor a
// handle that never moves looks like a hand.
// Threads: a plain value.
#pragma once

#include "config/types/vec2.h"

namespace touchline {

/// The device's mechanics at the tip. Estimates; a hand at least halves the acceleration.
struct TipMechanics {
    double mass_kg = 0.07;          // > 0
    double viscous_Ns_per_m = 0.2;  // >= 0
    double coulomb_N = 0.1;         // >= 0
    double count_m = 2e-4;          // motion for one encoder count, > 0
};

class HandPresence {
  public:
    explicit HandPresence(const TipMechanics& tip) : tip_(tip) {}

    /// Advances one tick of dt_s > 0: `force` was told in the tick before, velocity and position
    /// are the handle's now. The hand counts as off if
    ///   - forces of about 0.6 N and more moved the handle as its own mass and friction say, to
    ///     within a quarter, for 30 ms, without a moment in which they did not; or
    ///   - the handle stood still to 0.2 mm for 20 s under more than 0.5 N.
    /// It counts as back once the handle moves in another way; in the first case only after 0.5 s,
    /// in which the handle may coast. Returns is_off().
    bool step(Force force, Velocity velocity, Position position, double dt_s);

    [[nodiscard]] bool is_off() const { return is_off_; }

    /// True if the hand is off for the first reason: the handle moves on its own.
    [[nodiscard]] bool is_alone() const { return is_off_ && is_alone_; }

  private:
    [[nodiscard]] bool moves_alone(Force force, Velocity velocity, double dt_s);
    void judge_window(Velocity gained);
    [[nodiscard]] bool stands_still(Force force, Position position, double dt_s);
    void look_for_hand(Position position, double dt_s);

    TipMechanics tip_;
    bool is_off_ = false;
    bool is_alone_ = false;
    // A window of 10 ms, and the speed that the device alone would gain in it.
    Velocity at_begin_;
    Velocity expected_;
    Velocity rate_;  // of that, per second, as late as the measured velocity is
    double window_s_ = 0.0;
    double alone_s_ = 0.0;    // explained so far, without a contradiction
    double neutral_s_ = 0.0;  // since a window last told anything
    // For standing still: where the handle has been meanwhile.
    Position low_, high_;
    double rest_s_ = 0.0;
    double wait_s_ = 0.0;  // off: before motion is a hand's
    Position left_at_;     // off: from where a hand would move it
};

}  // namespace touchline
