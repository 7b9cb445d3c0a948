// Tells whether a hand moves the handle, by the work that a hand must have done. A handle that
// shakes, is led, is drawn into a groove or coasts moves too, and nobody is there.
// Threads: a plain value.
#pragma once

#include "config/types/vec2.h"
#include "haptics/safety/hand_presence.h"

#include <cstdint>

namespace touchline {

class HandWork {
  public:
    explicit HandWork(const TipMechanics& tip) : tip_(tip) {}

    /// Advances one tick of dt_s > 0: `force` was told in the tick before, `position` is the
    /// handle's now, both in one frame. A stroke is 2 mm on a straight way, within 2 s, of the
    /// handle without its shaking. A hand made it if friction took at least twice the work that
    /// the force and the handle's own motion gave. Two such strokes within 3 s are a move.
    void step(Force force, Position position, double dt_s);

    /// For a tick in which motion tells nothing: the handle shakes or leads on purpose, or its
    /// place is not known. The next half second tells nothing either.
    void disturb(Position position);

    /// How many moves there were so far.
    [[nodiscard]] std::uint32_t moves() const { return moves_; }

  private:
    void begin_stroke(Velocity velocity);
    void judge_stroke(Velocity velocity);

    TipMechanics tip_;
    // Of the handle, without what is faster than a hand.
    Position place_;
    Force force_;
    double calm_s_ = 0.0;  // since the last disturbance
    // The stroke under way.
    Position from_;
    Velocity at_first_;
    double given_J_ = 0.0;  // by the force
    double stroke_s_ = 0.0;
    double since_s_ = 1e9;  // the last stroke of a hand
    std::uint32_t moves_ = 0;
};

}  // namespace touchline
