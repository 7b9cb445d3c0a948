// The only place that limits force. One chain per device, stepped once a servo tick: finite check
// -> gain (arming, ramp, fade) -> pose (0 near singularities) -> vector clamp -> slew -> joint
// torques, both scaled together when one motor saturates.
// Every limit holds for any doubles; where anything is in doubt the force is zero.
// Threads: one, the servo's. A plain value; no allocation, lock, clock or log.
#pragma once

#include "config/types/vec2.h"
#include "haptics/pantograph/kinematics.h"
#include "haptics/pantograph/profile.h"

#include <cstdint>
#include <optional>

namespace touchline {

/// off: zero. armed: zero until the wanted force was small for a while, so that nobody is pushed
/// when force comes on. ramp: gain on its way up or down. live: full gain. fault: zero until
/// stopped and armed again.
enum class ForceState : std::uint8_t { off, armed, ramp, live, fault };

enum class Fault : std::uint8_t { none, not_finite, device_lost };

/// What reduced the force of this tick; the gravest of several.
enum class Limit : std::uint8_t { none, gain, slew, torque, force, pose, unreachable, fault };

struct ForceLimits {
    double force_N = 3.0;            // vector, on the hand
    double torque_Nm = 0.9 * 0.123;  // each motor: 0.9 of the firmware's own limit
    double rise_N_per_s = 300.0;     // growth of |force|
    double change_N_per_s = 1500.0;  // change of the vector: a soft stop from 3 N takes 2 ms
    double condition_full = 5.0;     // full force up to this condition of the Jacobian ...
    double condition_zero = 6.0;     // ... none from here on
    double arm_force_N = 0.1;        // armed -> ramp after the wanted force ...
    double arm_s = 0.2;              // ... was below this for so long
    double start_s = 0.5;            // gain 0 -> 1 after arming
    double resume_s = 0.15;          // gain 0 -> 1 after a fade
    double fade_s = 0.05;            // gain 1 -> 0
};

/// Limits of a device: min(3 N, the device's), 0.9 of its torque.
[[nodiscard]] ForceLimits limits_of(const DeviceProfile& profile);

/// The force that the motors are told to make, in D, and how it came about.
struct SafeForce {
    Force force_D;
    JointTorques torques;
    Limit limit = Limit::none;
};

class ForceChain {
  public:
    explicit ForceChain(const ForceLimits& limits) : limits_(limits) {}

    /// off -> armed. Without effect in any other state.
    void arm();
    /// Gain to 0 within fade_s; is_faded() tells when. Then resume() or stop().
    void fade();
    /// Gain back to 1 within resume_s. Without effect unless live or ramping.
    void resume();
    /// Zero at once, off; clears a fault.
    void stop();
    /// Zero at once, and it stays so until stop().
    void fail(Fault cause);

    /// One tick. `jacobian`: of the pose now, nothing when the pose is unknown or out of reach.
    /// |force|
    /// <= force_N, |torque| <= torque_Nm; |force| grows by at most rise_N_per_s dt_s, changes by at
    /// most change_N_per_s dt_s unless it must go to zero or a motor saturates, which keeps its
    /// direction. A wanted force, Jacobian or dt_s that is not finite is a fault.
    [[nodiscard]] SafeForce step(Force wanted_D, const std::optional<Jacobian>& jacobian,
                                 double dt_s);

    [[nodiscard]] ForceState state() const { return state_; }

    [[nodiscard]] Fault cause() const { return cause_; }

    /// No force can act: gain 0.
    [[nodiscard]] bool is_faded() const { return gain_ == 0.0; }

  private:
    void step_gain(Force wanted_D, double dt_s);
    [[nodiscard]] Force slewed(Force target_D, double dt_s) const;
    SafeForce none(Limit limit);

    ForceLimits limits_;
    ForceState state_ = ForceState::off;
    Fault cause_ = Fault::none;
    double gain_ = 0.0;
    double gain_per_s_ = 0.0;  // > 0 rising, < 0 fading
    double quiet_s_ = 0.0;     // armed: how long the wanted force has been small
    Force last_D_;             // commanded in the last tick
};

}  // namespace touchline
