// What should push the hand in a tick: lines, the frame of the drawing area, guidance and patterns,
// before any limit of safety.
// Threads: one, the servo's. No allocation, lock, clock, log or system call.
#pragma once

#include "config/types/hand_state.h"
#include "config/types/vec2.h"
#include "haptics/contact/event_detector.h"
#include "haptics/guidance/guidance.h"
#include "haptics/safety/stability_monitor.h"
#include "haptics/servo/handle_motion.h"
#include "haptics/servo/rendering.h"

#include <span>

namespace touchline {

/// What the rest of the loop allows in a tick.
struct LoopState {
    double period_s = 1e-3;    // as planned, > 0
    bool is_silent = false;    // no force acts: contact may be dropped
    bool is_live = false;      // force acts in full, and is wanted
    double spring_gain = 1.0;  // below 1 where the loop rang
    StiffnessBound bound;
    double damping_Ns_per_m = 0.0;
};

/// The default is that of a tick without a pose.
struct WantedForce {
    Force force;            // on the hand, in W: all of it, damped
    Force active;           // of that, by guidance and pattern: it may give energy, and swing
    double turn_Nm = 0.0;   // on the hand, damped as the force is
    double shape_Nm = 0.0;  // the held shape's own, at full gain
    // The springs, softened where they rang.
    double lines_N = 0.0;
    double lines_Nm = 0.0;
    double stored_J = 0.0;
    double stiffness_N_per_m = 1.0;
    bool is_continued = true;  // false: what is felt changes, and energies cannot be compared
};

class HandForce {
  public:
    /// `period_s` > 0 is the loop's.
    HandForce(const DeviceProfile& profile, double period_s);

    /// See ServoStep::lend().
    void lend(ShapeInHand* hand) { hand_ = hand; }

    /// Advances one tick: level -> contact -> damping -> frame, guidance, pattern. Another scene,
    /// proxy radius, capture width or shape waits until no force acts; the next map of the drawing
    /// that is felt comes in at full force, as soon as the hand cannot tell. Does nothing without a
    /// pose.
    [[nodiscard]] WantedForce step(const StepInput& input, const HandleReading& handle,
                                   const LoopState& loop);

    /// What is felt must change, so force must fade out.
    [[nodiscard]] bool is_swapping() const { return is_swapping_; }

    [[nodiscard]] const Rendering& rendering() const { return rendering_; }

    [[nodiscard]] HeldShape shape() const { return felt_.shape; }

    [[nodiscard]] Mode mode() const { return mode_; }

    /// As it acts, before the spring gain.
    [[nodiscard]] double stiffness_N_per_m() const { return stiffness_.stiffness_N_per_m(); }

    /// The report of guidance and pattern.
    [[nodiscard]] GuidanceStatus guidance() const;

    /// The last step's.
    [[nodiscard]] std::span<const ContactEvent> events() const { return events_.all(); }

    /// For one that was copied byte by byte: goes on with `scene`, the same one elsewhere in
    /// memory. Returns false if the bytes do not fit it, or if a shape was held.
    [[nodiscard]] bool rebind(const Scene* scene);

  private:
    /// What, with the scene, cannot change while the hand is in contact.
    struct Felt {
        double radius_m = 0.0;
        double capture_m = 0.0;
        HeldShape shape = HeldShape::none;

        friend bool operator==(const Felt&, const Felt&) = default;
    };

    [[nodiscard]] const Scene* scene_for(const StepInput& input, const ProbePose& handle,
                                         const LoopState& loop);
    void follow_wishes(const ServoCommands& commands, const Scene* scene, const ProbePose& handle,
                       bool is_silent);
    [[nodiscard]] ContactSettings settings_of(const ServoCommands& commands,
                                              double spring_gain) const;
    void bound_level(const ServoCommands& commands);
    void ramp_stiffness(double set_N_per_m, const HandleReading& handle, const LoopState& loop);
    [[nodiscard]] Force lead(const StepInput& input, const HandleReading& handle,
                             const LoopState& loop);
    void render(const ServoCommands& commands, const ProbePose& handle, const LoopState& loop);
    void share_lines(double capture_m, double period_s);
    [[nodiscard]] Force push(const ServoCommands& commands, const HandleReading& handle,
                             const LoopState& loop, WantedForce& wanted) const;
    void detect(double now_s, Position p_WH);

    /// A hand that is led holds a point, in a weak groove.
    [[nodiscard]] bool is_led() const { return guidance_.leads() || guidance_.is_pending(); }

    ShapeInHand* hand_ = nullptr;
    Felt felt_;
    bool is_swapping_ = false;
    Rendering rendering_;
    Budget budget_;  // of a tick
    Mode mode_ = Mode::wall;
    StiffnessRamp stiffness_;
    double line_share_ = 1.0;  // of what lines would push with
    Guidance guidance_;
    PatternPlayer pattern_;
    EventDetector detector_;
    TickEvents events_;
};

}  // namespace touchline
