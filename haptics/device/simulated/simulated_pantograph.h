// A pantograph and a hand in software, on the clock that the servo passes in: the same calls give
// the same bits. Models five-bar geometry, tip mass, viscous and Coulomb friction, encoder counts,
// motor limits, transport delay, a scale error of one arm and, if the profile has one, a turning
// handle. PantographPlant is the mechanics alone: joint torques in, motion of the tip out.
#pragma once

#include "config/types/vec2.h"
#include "haptics/device/joint_device.h"
#include "haptics/device/simulated/delayed.h"
#include "haptics/pantograph/profile.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace touchline {

// Simulated hands: a mass on a spring and damper that follow an intended path, held rigidly or
// through the skin. Threads: values; each intended path states its own rule.

struct HandModel {
    /// Between the tip and the hand's mass. Without it the hand holds the tip rigidly.
    struct Skin {
        double stiffness_N_per_m = 0.0;
        double damping_Ns_per_m = 0.0;
    };

    double mass_kg = 0.0;
    double damping_Ns_per_m = 0.0;   // to the intended path
    double stiffness_N_per_m = 0.0;  // to the intended path
    std::optional<Skin> skin;        // needs mass_kg > 0
};

inline constexpr HandModel no_hand{};                            // H0: the hand lets go
inline constexpr HandModel light_hand{0.03, 1.0, 50.0, {}};      // H1: a finger, a loose pen
inline constexpr HandModel normal_hand{0.10, 3.0, 300.0, {}};    // H2: a pen grip
inline constexpr HandModel relaxed_arm{0.554, 6.45, 135.0, {}};  // H3
inline constexpr HandModel stiff_arm{0.4, 12.0, 1000.0, {}};     // H4

/// Where the hand means to be.
struct Intention {
    Position position;
    Velocity velocity;
    double angle_rad = 0.0;  // if the handle turns
    double turn_rad_per_s = 0.0;
};

class IntendedPath {
  public:
    virtual ~IntendedPath() = default;
    /// Returns the intention in W, at t_s >= 0. No allocation, no lock.
    [[nodiscard]] virtual Intention at(double t_s) const = 0;

  protected:
    IntendedPath() = default;
    IntendedPath(const IntendedPath&) = default;
    IntendedPath(IntendedPath&&) = default;
    IntendedPath& operator=(const IntendedPath&) = default;
    IntendedPath& operator=(IntendedPath&&) = default;
};

/// Goes straight from way point to way point, and stands still before the first and after the last.
/// Threads: immutable. at() is O(log n).
class WaypointPath final : public IntendedPath {
  public:
    struct Waypoint {
        double t_s = 0.0;  // strictly increasing
        Position position;
        double angle_rad = 0.0;
    };

    /// Takes at least one way point.
    explicit WaypointPath(std::vector<Waypoint> waypoints) : waypoints_(std::move(waypoints)) {}

    [[nodiscard]] Intention at(double t_s) const override;

  private:
    std::vector<Waypoint> waypoints_;
};

/// A hand led by a pointer: it means to be at the place it was told last.
/// Threads: move_to() from any one thread, at() from any other; lock-free.
class MouseHand final : public IntendedPath {
  public:
    explicit MouseHand(Position start) { move_to(start); }

    /// In W; rounded to 10 nm within 0.1 m of the origin. A position that is not finite is ignored.
    void move_to(Position position);

    [[nodiscard]] Intention at(double t_s) const override;

  private:
    // Both coordinates as floats in one word, so that they change together.
    std::atomic<std::uint64_t> packed_{0};
};

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

/// A device's tip and the hand that holds it: the one integrator behind every simulation.
///   m x'' = F + k_h (x_d - x) + b_h (x_d' - x') - b x' - Coulomb friction
/// Semi-implicit: damping and friction are implicit, so neither can create energy, and friction
/// holds exactly. Threads: a plain value. No allocation.
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

/// The same for a turning handle and the fingers that hold it:
///   I phi'' = tau + k (phi_d - phi) + c (phi_d' - phi') - b phi' - Coulomb friction
/// Threads: a plain value. No allocation.
class HandleDynamics {
  public:
    /// Starts at rest at an angle. The fingers hold the handle at 10 mm from its axis.
    HandleDynamics(const TurningHandle& handle, const HandModel& hand, double start_rad)
        : handle_(handle), hand_(hand), angle_rad_(start_rad) {}

    /// Makes one integration step of h_s with the motor's torque and the hand's intention held.
    void step(double torque_Nm, const Intention& intention, double h_s);

    /// Other fingers take the handle where it is, or none do.
    void grip(const HandModel& hand) { hand_ = hand; }

    [[nodiscard]] double angle_rad() const { return angle_rad_; }

  private:
    TurningHandle handle_;
    HandModel hand_;
    double angle_rad_ = 0.0;
    double speed_rad_per_s_ = 0.0;
};

/// The mechanics of a pantograph and the hand that holds it. Boards, delays and counts, which lie
/// between a program and the motors, are not modelled here. Threads: one at a time; another thread
/// may lead the path if the path allows it. No allocation after construction.
class PantographPlant {
  public:
    /// The tip starts at rest where the path starts, or at the centre of the drawing area if that
    /// is out of reach. longest_step_s > 0 is the longest integration step.
    PantographPlant(const DeviceProfile& profile, const HandModel& hand, double longest_step_s,
                    std::shared_ptr<const IntendedPath> path);

    /// Sets the motors' torques from now on.
    void turn_motors(JointTorques torques, double handle_Nm = 0.0) {
        torques_ = torques;
        handle_Nm_ = handle_Nm;
    }

    /// Another hand takes the tip where it is, or none does.
    void grip(const HandModel& hand) {
        dynamics_.grip(hand);
        if (handle_) handle_->grip(hand);
    }

    /// Runs through span_s in even steps. Does nothing if it is not above 0.
    void advance(double span_s);

    /// Lets time pass while nothing moves.
    void skip_to(double t_s) { time_s_ = t_s; }

    [[nodiscard]] double time_s() const { return time_s_; }

    /// The true state of the tip in W.
    [[nodiscard]] const MassState& tip() const { return dynamics_.tip(); }

    /// The true angles; nothing if the tip was put out of reach.
    [[nodiscard]] std::optional<JointAngles> angles() const;

    [[nodiscard]] JointTorques torques() const { return torques_; }

    /// A turning handle's state; nothing if it does not turn.
    [[nodiscard]] const std::optional<HandleDynamics>& handle() const { return handle_; }

    [[nodiscard]] double handle_torque_Nm() const { return handle_Nm_; }

  private:
    [[nodiscard]] Force force_W() const;

    DeviceProfile profile_;
    double longest_step_s_;
    std::shared_ptr<const IntendedPath> path_;
    TipDynamics dynamics_;
    std::optional<HandleDynamics> handle_;
    double time_s_ = 0.0;
    JointTorques torques_;
    double handle_Nm_ = 0.0;
};

struct SimulationOptions {
    HandModel hand = normal_hand;
    double substep_s = 1.25e-4;      // longest integration step, > 0
    double arm_1_scale_error = 0.0;  // relative error of encoder 1, e.g. 0.015
};

/// Threads: as ForceDevice; another thread may lead the path if the path allows it.
class SimulatedPantograph final : public JointDevice {
  public:
    /// The tip starts at rest where the path starts, or at the centre of the drawing area if that
    /// is out of reach.
    SimulatedPantograph(const DeviceProfile& profile, const SimulationOptions& options,
                        std::shared_ptr<const IntendedPath> path);

    /// Advances the simulation to now_s (at most 0.1 s per call: a longer gap is a pause), then
    /// reads the encoders.
    [[nodiscard]] std::optional<JointAngles> read_angles(double now_s) override;

    /// Clamps each motor's torque as the firmware does; a torque that is not finite counts as zero.
    /// Takes effect after the profile's delay.
    [[nodiscard]] bool write_torques(JointTorques torques) override;

    [[nodiscard]] std::optional<double> handle_angle_rad() const override;

    void turn_handle(double torque_Nm) override;

    /// The true state of the tip in W, for tests and drawings.
    [[nodiscard]] const MassState& tip() const { return plant_.tip(); }

    /// The torques that act now.
    [[nodiscard]] JointTorques acting_torques() const { return plant_.torques(); }

    [[nodiscard]] double acting_handle_torque_Nm() const { return plant_.handle_torque_Nm(); }

  private:
    struct Torques {
        JointTorques torques;
        double handle_Nm = 0.0;
    };

    void advance_to(double t_s);

    DeviceProfile profile_;
    double arm_1_scale_error_;
    PantographPlant plant_;
    double handle_Nm_ = 0.0;  // goes with the next torques
    Delayed<Torques> pending_;
};

}  // namespace touchline
