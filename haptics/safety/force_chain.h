// The only place that limits force. One chain per device, stepped once a servo tick: finite check,
// state and gain -> pose (0 near singularities) -> heat of the motors -> damping where energy was
// given -> vector clamp -> one-sided speed limit -> slew -> joint torques, both scaled together
// when one motor saturates -> the energy given to the hand is booked. A device that takes forces
// has no joints: no torques, and for the pose how far it is off its plane, but all the rest; the
// speed is that of all its axes. Every limit holds for any doubles; if
// anything is in doubt, the force is zero. Threads: one, the servo's. A plain value; no allocation,
// lock, clock or log.
#pragma once

#include "config/types/hand_state.h"
#include "config/types/vec2.h"
#include "haptics/pantograph/kinematics.h"
#include "haptics/pantograph/profile.h"
#include "haptics/safety/guards.h"
#include "haptics/safety/hand_presence.h"

#include <cstdint>
#include <optional>
#include <span>

namespace touchline {

// Whether force may act: off -> armed -> ramp -> live, any -> fault. A pure function of the state
// before, the conditions now and the time passed, so that every combination can be tried.

/// How a fault ends once its cause is gone. The operator can end every fault.
enum class FaultClears : std::uint8_t {
    when_gone,    // by itself
    on_rearm,     // when force is switched off
    by_operator,  // when the operator says so
};

struct FaultRule {
    Fault fault = Fault::none;
    FaultClears clears = FaultClears::when_gone;
};

/// One rule for each fault except none, in order of severity, the gravest last. A graver fault is
/// never easier to clear.
[[nodiscard]] std::span<const FaultRule> fault_rules();

/// Faults are a set, one bit each.
[[nodiscard]] constexpr std::uint16_t bit_of(Fault fault) {
    return static_cast<std::uint16_t>(1U << static_cast<unsigned>(fault));
}

/// The conditions in a tick.
struct SafetyFlags {
    bool is_wanted = true;     // force is switched on
    bool is_quiet = true;      // the wanted force is small
    bool is_fading = false;    // gain to 0: a picture is changed, or the servo ends
    bool is_hand_off = false;  // nobody holds the handle
    bool is_cleared = false;   // the operator clears a fault, in this tick
    std::uint16_t faults = 0;  // conditions that hold now, bit_of() each but none
};

struct SafetyState {
    ForceState state = ForceState::off;
    Fault fault = Fault::none;
    double gain = 0.0;        // 0 ... 1, of the force
    double quiet_s = 0.0;     // armed: how long the wanted force has been small
    double rise_per_s = 0.0;  // of the gain when it goes up

    friend bool operator==(const SafetyState&, const SafetyState&) = default;
};

struct SafetyTimes {
    double arm_s = 0.2;     // quiet for so long: armed -> ramp
    double start_s = 0.5;   // gain 0 -> 1 after arming
    double resume_s = 0.3;  // gain 0 -> 1 after fading
    double fade_s = 0.05;   // gain 1 -> 0
};

/// Returns the state dt_s later. A dt_s that is not above 0 is a fault of a number. If two faults
/// meet, the graver one stays. O(1).
[[nodiscard]] SafetyState next(const SafetyState& before, const SafetyFlags& flags,
                               const SafetyTimes& times, double dt_s);

inline constexpr double most_force_N = 3.0;  // no device, file or operator gets beyond it

struct ForceLimits {
    double force_N = most_force_N;   // vector, on the hand
    double torque_Nm = 0.9 * 0.123;  // each motor: 0.9 of the firmware's own limit
    double rise_N_per_s = 300.0;     // growth of |force|
    double change_N_per_s = 1500.0;  // change of the vector: a soft stop from 3 N takes 2 ms
    double condition_full = 5.0;     // full force up to this condition of the Jacobian ...
    double condition_zero = 6.0;     // ... none from here on
    double arm_force_N = 0.1;        // armed: the wanted force is small below this
    double continuous_torque_Nm = 0.6 * 0.123;  // each motor
    double warming_s = 60.0;                    // its time constant
    /// What a device without joints bears forever; nothing: it has joints.
    std::optional<double> continuous_N;
    SafetyTimes times;
    TipMechanics tip;
    HandleLimits handle;
};

/// Returns a device's limits: min(most_force_N, the device's), 0.9 of its torque, and what its
/// motors bear forever.
[[nodiscard]] ForceLimits limits_of(const DeviceProfile& profile);

/// The inputs of a tick, in the device's frame.
struct ChainInput {
    Force wanted_D;                    // on the hand
    bool is_placed = false;            // p_D is where the handle is now
    std::optional<Jacobian> jacobian;  // of the pose of a device with joints, which needs it
    Position p_D;                      // handle, the last known
    Velocity velocity_D;
    double across_m_per_s = 0.0;  // of a third axis
    double across_N = 0.0;        // what its device makes along it
    double on_plane = 1.0;        // 0 ... 1: how much of the force acts where the handle is off it
    double wanted_turn_Nm = 0.0;  // on the hand, counter-clockwise
    double handle_rad = 0.0;      // how far the handle is turned, the last known
    double turn_rad_per_s = 0.0;
    double share = 1.0;               // of force and limit that may act, 0 ... 1; 0: off
    double ceiling_N = most_force_N;  // the operator's, below the device's limit
    bool is_wanted = true;            // force is switched on
    bool is_fading = false;           // force to 0 within fade_s, for as long as this is said
    bool is_cleared = false;          // the operator clears a fault
    bool is_stopped = false;          // emergency stop
    bool is_unreadable = false;       // what the device tells is no number
    bool is_lost = false;             // the device is
    bool has_jumped = false;          // the handle, to where it cannot have moved
    std::uint64_t cuts = 0;           // of the stability monitor, so far
};

/// The force that the motors are told to make, in D, and how it came about.
struct SafeForce {
    Force force_D;
    JointTorques torques;       // of a device with joints
    double handle_Nm = 0.0;     // of the motor at the handle, where there is one
    double plane_share = 0.0;   // 0 ... 1, of what holds a device without joints to the plane
    Limit limit = Limit::none;  // the gravest
};

class ForceChain {
  public:
    /// Starts in the off state.
    explicit ForceChain(const ForceLimits& limits);

    /// Advances one tick of dt_s > 0. |force| <= force_N, |torque| <= torque_Nm; |force| grows by
    /// at most rise_N_per_s dt_s. The force changes by at most change_N_per_s dt_s, unless it must
    /// go to zero, would drive on a hand that is too fast, or a motor saturates, which keeps its
    /// direction. Anything that is not finite is a fault. O(1).
    [[nodiscard]] SafeForce step(const ChainInput& input, double dt_s);

    [[nodiscard]] ForceState state() const { return safety_.state; }

    /// True if no force can act, because the gain is 0.
    [[nodiscard]] bool is_faded() const { return safety_.gain == 0.0; }

    /// The last tick's status.
    [[nodiscard]] const ForceStatus& status() const { return status_; }

    /// As MotorHeat::warm(): the motors worked before this chain.
    void warm(double rise) { heat_.warm(rise); }

    /// As MotorHeat::rise().
    [[nodiscard]] double motor_heat() const { return heat_.rise(); }

  private:
    [[nodiscard]] std::uint16_t faults(const ChainInput& input, double dt_s);
    [[nodiscard]] bool is_ringing(std::uint64_t cuts, double dt_s);
    [[nodiscard]] SafeForce limited(const ChainInput& input, double dt_s);
    [[nodiscard]] Force bounded(const ChainInput& input, bool is_braked);
    [[nodiscard]] double limited_turn(const ChainInput& input, double dt_s);
    [[nodiscard]] double plane_share(const ChainInput& input, double dt_s) const;
    [[nodiscard]] Force slewed(Force target_D, double dt_s) const;
    void book(const ChainInput& input, const SafeForce& told, double dt_s);
    void forget_motion();
    SafeForce none(Limit limit);
    void limit_by(Limit limit);

    ForceLimits limits_;
    SafetyState safety_;
    SpeedWatch speed_;
    MotorHeat heat_;
    EnergyGuard energy_;
    HandleLimit handle_;
    HandPresence hand_;
    ForceStatus status_;
    Force last_D_;              // told in the last tick
    Position p_D_;              // in the last tick
    double handle_rad_ = 0.0;   // the same
    double plane_share_ = 0.0;  // told in the last tick
    bool has_position_ = false;
    std::uint64_t cuts_ = 0;    // known of
    double recent_cuts_ = 0.0;  // forgotten in 1 s
};

}  // namespace touchline
