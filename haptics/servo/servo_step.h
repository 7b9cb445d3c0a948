// One servo tick as a pure step: joint angles and commands in, joint torques and hand state out.
// Threads: one, the servo's. No allocation, lock, log, clock or system call.
#pragma once

#include "config/types/hand_state.h"
#include "config/types/vec2.h"
#include "haptics/collision/scene.h"
#include "haptics/contact/contact_machine.h"
#include "haptics/contact/event_detector.h"
#include "haptics/guidance/guidance.h"
#include "haptics/guidance/pattern.h"
#include "haptics/pantograph/profile.h"
#include "haptics/resolution/cost_term.h"
#include "haptics/resolution/level_rule.h"
#include "haptics/resolution/shape_level_rule.h"
#include "haptics/safety/force_chain.h"
#include "haptics/safety/position_guard.h"
#include "haptics/safety/stability_monitor.h"
#include "haptics/safety/stiffness_ramp.h"
#include "haptics/servo/exchange.h"
#include "haptics/servo/handle_turn.h"
#include "haptics/servo/loop_settings.h"
#include "haptics/servo/real_time.h"
#include "haptics/servo/shape_in_hand.h"
#include "haptics/servo/velocity_estimate.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace touchline {

struct StepInput {
    double now_s = 0.0;                 // since the servo started
    std::uint64_t missed_ticks = 0;     // total so far
    std::optional<JointAngles> angles;  // nothing if the device did not answer
    ServoCommands commands;
    const Scene* scene = nullptr;  // wanted scene; must live until scene() is another one
    double delay_s = 0.0;          // from reading the angles to the torques' effect, as measured
    // The share of the force that is let through, 0 ... 1. At 0 force is off, and it comes back by
    // the arm rule.
    double force_share = 1.0;
    std::optional<double> handle_rad = std::nullopt;  // if the handle turns
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
    void lend(ShapeInHand* hand) { hand_ = hand; }

    /// kinematics -> handle in W -> level -> contact -> damping -> frame, guidance, pattern ->
    /// force chain. The stiffness is the commanded one times the tier's share, kept below what the
    /// measured period and delay allow (loop_settings.h). A new scene, proxy radius or capture
    /// width first fades force to zero, drops the contact and fades in again; a new mode takes over
    /// under the hand, and the old mode's force fades into its own. A device that does not answer
    /// gets no force, and after 20 ms it is a fault, as is one that refuses torques. In a fault
    /// everything goes on except the force (haptics/safety/safety_state.h). While guidance leads
    /// the hand, lines are a weak groove in every mode.
    [[nodiscard]] JointTorques step(const StepInput& input);

    /// The last step's torque for a motor at the handle.
    [[nodiscard]] double handle_torque_Nm() const { return handle_Nm_; }

    /// True if part of the step's state lies in another object.
    [[nodiscard]] bool holds_shape() const { return felt_.shape != HeldShape::none; }

    /// Fades force out for good; is_silent() tells when it has.
    void fade_out() { is_stopping_ = true; }

    [[nodiscard]] bool is_fading_out() const { return is_stopping_; }

    [[nodiscard]] bool is_silent() const { return chain_.is_faded(); }

    /// Tells the step that the device took no torques.
    void lose_device() { is_refused_ = true; }

    /// The last step's report.
    [[nodiscard]] const ServoReport& report() const { return report_; }

    /// The last step's events.
    [[nodiscard]] std::span<const ContactEvent> events() const { return events_.all(); }

    /// The scene felt now.
    [[nodiscard]] const Scene* scene() const { return felt_.scene; }

  private:
    /// What cannot change while the hand is in contact.
    struct Felt {
        const Scene* scene = nullptr;
        double radius_m = 0.0;
        double capture_m = 0.0;
        HeldShape shape = HeldShape::none;

        friend bool operator==(const Felt&, const Felt&) = default;
    };

    [[nodiscard]] bool rebind(const Scene* scene, const DeviceProfile& profile);
    [[nodiscard]] std::optional<Pose> find_pose(const StepInput& input, double dt_s);
    [[nodiscard]] SafeForce make_safe(Force wanted_W, const std::optional<Pose>& pose,
                                      const StepInput& input);
    void follow_wishes(const StepInput& input);
    void begin_to_feel();
    void turn(const StepInput& input, double dt_s);
    void follow_speed(double dt_s);
    void bound_level(const ServoCommands& commands);
    [[nodiscard]] StiffnessBound stiffness_bound() const;
    void measure_loop(const StepInput& input, double dt_s);
    [[nodiscard]] Force feel(const ServoCommands& commands, double dt_s);
    void feel_point(const ServoCommands& commands, double level);
    void feel_shape(double level);

    [[nodiscard]] ProbePose handle_pose() const { return {p_WH_.x, p_WH_.y, turn_.angle_rad()}; }

    [[nodiscard]] double damped_twist_Nm() const;

    [[nodiscard]] double rendered_level() const {
        return holds_shape() ? hand_->rendered_level() : contact_.rendered_level();
    }

    void lead(const StepInput& input);
    void share_lines(const ServoCommands& commands, bool is_led);
    void watch(Force told, Force wanted, double dt_s);
    void detect(const StepInput& input);
    void fill(const StepInput& input, const SafeForce& safe);

    DeviceProfile profile_;
    double period_s_;
    TierLimits tier_;
    ForceChain chain_;
    PositionGuard position_guard_;
    Sample sample_ = Sample::good;
    std::optional<Pose> good_pose_;  // last one used
    LevelLimits level_limits_;
    LevelRule level_rule_;
    CostTerm cost_;
    int boxes_per_tick_;
    StiffnessRamp stiffness_;
    LoopSettings loop_;
    double measured_period_s_;
    double measured_delay_s_ = 0.0;
    int ticks_to_measure_ = 0;
    VelocityEstimate velocity_;
    StabilityMonitor monitor_;
    ContactMachine contact_;
    ContactReport contact_report_;
    EventDetector detector_;
    Guidance guidance_;
    PatternPlayer pattern_;
    Mode mode_ = Mode::wall;   // being rendered
    Force active_;             // from guidance and pattern, in this tick
    double frame_J_ = 0.0;     // stored in the frame
    double line_share_ = 1.0;  // of what lines would push with
    double ceiling_N_ = most_force_N;
    TickEvents events_;
    Felt felt_;
    ShapeInHand* hand_ = nullptr;
    HandleTurn turn_;
    ShapeSpeed shape_speed_{0.0};
    double proxy_angle_rad_ = 0.0;
    double twist_Nm_ = 0.0;   // the shape's, on the hand
    double handle_Nm_ = 0.0;  // sent to the handle's motor
    bool is_shape_placed_ = false;
    Position p_WH_;   // last known
    Position moved_;  // handle's way since the tick before
    double last_s_ = 0.0;
    double silent_s_ = 0.0;  // since the device last answered
    bool is_swapping_ = false;
    bool is_refused_ = false;  // the last torques were
    std::uint32_t faults_cleared_ = 0;
    bool is_stopping_ = false;
    ServoReport report_;
};

}  // namespace touchline
