// One servo tick as a pure step: what the device tells and commands in, what it is told and hand
// state out. Threads: one, the servo's. No allocation, lock, log, clock or system call.
#pragma once

#include "haptics/collision/scene.h"
#include "haptics/pantograph/profile.h"
#include "haptics/safety/force_chain.h"
#include "haptics/safety/hand_work.h"
#include "haptics/safety/stability_monitor.h"
#include "haptics/servo/exchange.h"
#include "haptics/servo/hand_force.h"
#include "haptics/servo/handle_motion.h"
#include "haptics/servo/handle_rest.h"
#include "haptics/servo/loop_settings.h"
#include "haptics/servo/real_time.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace touchline {

/// What the motors are told of the force that should push the hand: the force chain, with the watch
/// over ringing that softens the springs from the next tick on.
class MotorForce {
  public:
    explicit MotorForce(const DeviceProfile& profile) : chain_(limits_of(profile)) {}

    /// Advances one tick; `period_s` > 0 is the planned one. `is_fading`: force to zero within 50
    /// ms. A device that has been silent for 20 ms, or that took no command, is a fault.
    [[nodiscard]] SafeForce step(const DeviceProfile& profile, const StepInput& input,
                                 const HandleReading& handle, const WantedForce& wanted,
                                 bool is_fading, double period_s);

    /// Tells it that the device took no command.
    void lose_device() { is_refused_ = true; }

    [[nodiscard]] bool is_silent() const { return chain_.is_faded(); }

    [[nodiscard]] bool is_live() const { return chain_.state() == ForceState::live; }

    /// Of the springs, below 1 where they rang.
    [[nodiscard]] double spring_gain() const { return monitor_.gain(); }

    [[nodiscard]] const ForceStatus& status() const { return chain_.status(); }

    /// As ForceChain::warm().
    void warm(double rise) { chain_.warm(rise); }

    [[nodiscard]] double motor_heat() const { return chain_.motor_heat(); }

  private:
    void watch(Force told, const HandleReading& handle, const WantedForce& wanted);

    ForceChain chain_;
    StabilityMonitor monitor_;
    double ceiling_N_ = most_force_N;
    bool is_refused_ = false;  // the last command was
    std::uint32_t faults_cleared_ = 0;
};

class ServoStep {
  public:
    /// `period_s` > 0 is the loop's. Of `tier`, the stiffness and the damping are used. Force is
    /// armed at once.
    ServoStep(const DeviceProfile& profile, double period_s, const TierLimits& tier = {});

    /// Restores the step that lay in memory as these bytes, in the same build, and felt `scene`
    /// (null: none), which may lie elsewhere now. Returns nothing if the bytes cannot be such a
    /// step: sizes and indices are checked, values are not.
    [[nodiscard]] static std::optional<ServoStep> from_memory(std::span<const std::byte> bytes,
                                                              const Scene* scene,
                                                              const DeviceProfile& profile);

    /// Gives the step the object that holds shapes, which must outlive it. Without one, every hand
    /// holds a point.
    void lend(ShapeInHand* hand) { hand_force_.lend(hand); }

    /// Where the handle is -> what should push the hand -> what the motors are told. The stiffness
    /// is the commanded one times the tier's share, kept below what the measured period and delay
    /// allow (loop_settings.h). A new scene, proxy radius or capture width first fades force to
    /// zero, drops the contact and fades in again; a new mode takes over under the hand, and the
    /// old mode's force fades into its own. A device that does not answer gets no force, and after
    /// 20 ms it is a fault, as is one that refuses a command. In a fault everything goes on except
    /// the force (haptics/safety/force_chain.h). While guidance leads the hand, lines are a weak
    /// groove in every mode.
    [[nodiscard]] DeviceCommand step(const StepInput& input);

    /// True if part of the step's state lies in another object.
    [[nodiscard]] bool holds_shape() const { return hand_force_.rendering().holds_shape(); }

    /// Fades force out for good; is_silent() tells when it has.
    void fade_out() { is_stopping_ = true; }

    [[nodiscard]] bool is_fading_out() const { return is_stopping_; }

    [[nodiscard]] bool is_silent() const { return motor_force_.is_silent(); }

    /// True if the next tick may come as late as resting_period_s: the commands allow it, no force
    /// is wanted, and the handle has stood still for HandleRest::least_s. The first tick that sees
    /// it move, or is told of force, ends it.
    [[nodiscard]] bool is_resting() const { return rest_.is_resting(); }

    /// Tells the step that the device took no command.
    void lose_device() { motor_force_.lose_device(); }

    /// The motors are as warm as this from another servo's work (MotorHeat), >= 0.
    void warm(double rise) { motor_force_.warm(rise); }

    /// How warm the motors are (MotorHeat): 1 is rated.
    [[nodiscard]] double motor_heat() const { return motor_force_.motor_heat(); }

    /// The last step's report.
    [[nodiscard]] const ServoReport& report() const { return report_; }

    /// The last step's events.
    [[nodiscard]] std::span<const ContactEvent> events() const { return hand_force_.events(); }

    /// The scene felt now.
    [[nodiscard]] const Scene* scene() const { return hand_force_.rendering().scene(); }

  private:
    [[nodiscard]] bool rebind(const Scene* scene, const DeviceProfile& profile);
    [[nodiscard]] LoopState loop_state(const ServoCommands& commands) const;
    [[nodiscard]] double planned_s(double now_s) const;
    void rest(const StepInput& input, const HandleReading& handle, const DeviceCommand& command);
    void watch_hand(const HandleReading& handle, Force active);
    void fill(const StepInput& input, const HandleReading& handle, const WantedForce& wanted,
              const SafeForce& safe);

    DeviceProfile profile_;
    MeasuredLoop loop_;
    HandleMotion handle_;
    HandForce hand_force_;
    MotorForce motor_force_;
    HandWork hand_work_;
    HandleRest rest_;
    double last_s_ = 0.0;
    bool is_stopping_ = false;
    ServoReport report_;
};

}  // namespace touchline
