// Simulates a device's tip and the hand that holds it. This is the one integrator behind every
// simulation.
//   m x'' = F + k_h (x_d - x) + b_h (x_d' - x') - b x' - Coulomb friction
// Semi-implicit: damping and friction are implicit, so neither can create energy, and friction
// holds exactly. Threads: a plain value. No allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/device/hand.h"

namespace touchline {

struct TipParameters {
    double mass_kg = 0.05;          // > 0
    double viscous_Ns_per_m = 0.1;  // >= 0
    double coulomb_N = 0.05;        // >= 0, on the tip
};

/// A point mass.
struct MassState {
    Position position;
    Velocity velocity;
};

class TipDynamics {
  public:
    /// Starts at rest at `start`, as does the hand.
    TipDynamics(const TipParameters& tip, const HandModel& hand, Position start)
        : tip_(tip), hand_(hand), tip_state_{start, {}}, hand_state_{start, {}} {}

    /// Makes one integration step of h_s with the device's force and the hand's intention held.
    void step(Force force, const Intention& intention, double h_s);

    /// Stops the tip at `position`, a mechanical end stop.
    void stop_at(Position position);

    void set_velocity(Velocity velocity) { tip_state_.velocity = velocity; }

    /// Another hand takes the tip where it is, or none does.
    void grip(const HandModel& hand) {
        hand_ = hand;
        hand_state_ = tip_state_;
    }

    [[nodiscard]] const MassState& tip() const { return tip_state_; }

    /// The state of the hand's own mass if it holds through the skin; else the tip's state.
    [[nodiscard]] const MassState& hand() const { return hand_.skin ? hand_state_ : tip_state_; }

  private:
    TipParameters tip_;
    HandModel hand_;
    MassState tip_state_;
    MassState hand_state_;
};

}  // namespace touchline
