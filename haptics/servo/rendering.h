// Haptic rendering: the force of lines on what is in the hand, a point or a shape, at a level of
// resolution that follows the hand's speed. The servo and `touchline feel` step the same code.
// Threads: one, the servo's, except for the constructor of ShapeInHand.
#pragma once

#include "config/types/hand_state.h"
#include "haptics/collision/scene.h"
#include "haptics/contact/contact_machine.h"
#include "haptics/pantograph/profile.h"
#include "haptics/probe/probe_proxy.h"
#include "haptics/probe/probe_shape.h"
#include "haptics/resolution/level_rule.h"

#include <vector>

namespace touchline {

/// A shape in the hand and its proxy among the lines; none: the hand holds a point.
struct HeldProbe {
    const ProbeShape* shape = nullptr;
    ProbeProxy* proxy = nullptr;
};

/// The shapes that may be held, and the proxy of the one that is. It is the only part of the
/// servo's step that is not one flat value.
class ShapeInHand {
  public:
    /// Builds the shapes and allocates all memory that steps need.
    ShapeInHand();

    [[nodiscard]] HeldProbe probe(HeldShape shape);

  private:
    std::vector<ProbeShape> shapes_;  // by HeldShape
    ProbeProxy proxy_;
};

/// The result of one step.
struct Rendered {
    ContactReport contact;   // of a shape: the first
    double twist_Nm = 0.0;   // a shape's, on the hand
    double angle_rad = 0.0;  // of a shape's proxy
    bool is_placed = false;  // false: lines still pass through the shape, and nothing is felt
};

/// A flat value but for the scene and the shape. No allocation, lock, clock or log but in place(),
/// for a shape's proxy that has never been placed.
class Rendering {
  public:
    /// The profile's encoders and bandwidth bound the level, and `period_s` > 0 its cost.
    Rendering(const DeviceProfile& profile, double period_s);

    /// Drops the contact, and feels another scene (null: none) with a point of radius_m or with
    /// `probe`. All must outlive their use. Then call bound_level() and place().
    void begin(const Scene* scene, double radius_m, const HeldProbe& probe);

    /// Goes on with `scene`, a map of the same drawing, if its lines push the handle as those
    /// before do; else changes nothing and returns false, also where a shape is held. Costs the
    /// steps of three ticks. `scene` must outlive its use.
    [[nodiscard]] bool follow(const Scene& scene, const ProbePose& handle,
                              const ContactSettings& settings, const Budget& budget);

    /// Places the proxy at the handle: free, or a shape not placed yet.
    void place(const ProbePose& handle, double level);

    /// Takes the handle's speed into account; dt_s > 0. The pose is finite.
    void measure_speed(const ProbePose& handle, double dt_s);

    /// Sets the operator's bounds, and the one that the work of the last step asks for.
    void bound_level(double finest, double coarsest);

    /// The level by all that is known now.
    [[nodiscard]] double level() const { return level_rule_.level(); }

    /// Advances one tick of dt_s > 0 at the wanted `level`, and books its work. Of the settings, a
    /// shape takes the stiffness. Without a scene, the proxy is at the handle. See
    /// ContactMachine::step() and ProbeProxy::step().
    const Rendered& step(const ProbePose& handle, double level, const ContactSettings& settings,
                         const Budget& budget, double dt_s);

    /// Books a tick without a step.
    void skip_step() { (void)cost_.step({}, rendered_level()); }

    [[nodiscard]] const Rendered& rendered() const { return rendered_; }

    /// The point's place among the lines.
    [[nodiscard]] Position proxy() const { return contact_.proxy().centre; }

    [[nodiscard]] double rendered_level() const {
        return holds_shape() ? probe_.proxy->rendered_level() : contact_.rendered_level();
    }

    [[nodiscard]] bool holds_shape() const { return probe_.proxy != nullptr; }

    [[nodiscard]] const Scene* scene() const { return scene_; }

    [[nodiscard]] const LevelRule& level_rule() const { return level_rule_; }

    /// For one that was copied byte by byte: goes on with `scene`, the same one elsewhere in
    /// memory. Returns false if the bytes do not fit it, or if a shape was held.
    [[nodiscard]] bool rebind(const Scene* scene);

  private:
    void take(const Scene& scene, double radius_m);
    void feel_shape(const ProbePose& handle, double level, double stiffness_N_per_m,
                    const Budget& budget, double dt_s);

    const Scene* scene_ = nullptr;
    HeldProbe probe_;
    LevelLimits limits_;
    LevelRule level_rule_;
    ShapeSpeed shape_speed_{0.0};
    double period_s_;
    CostTerm cost_;
    ContactMachine contact_;
    Rendered rendered_;
};

}  // namespace touchline
