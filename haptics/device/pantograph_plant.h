// The mechanics of a pantograph and the hand that holds it: joint torques in, motion of the tip
// out. Boards, delays and counts, which lie between a program and the motors, are not modelled
// here.
#pragma once

#include "config/types/vec2.h"
#include "haptics/device/hand.h"
#include "haptics/device/handle_dynamics.h"
#include "haptics/device/tip_dynamics.h"
#include "haptics/pantograph/profile.h"

#include <memory>
#include <optional>

namespace touchline {

/// Threads: one at a time; another thread may lead the path if the path allows it. No allocation
/// after construction.
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

}  // namespace touchline
