// Leads the hand by the handle: along the outlines, to a place, or to the nearest line. The force
// pulls towards a point that goes ahead and waits for the hand; it lets go within 50 ms.
// Threads: one, the servo's. A plain value; no allocation, lock, clock or log.
#pragma once

#include "config/types/guidance.h"
#include "config/types/vec2.h"
#include "haptics/collision/scene.h"
#include "haptics/guidance/leading_point.h"

#include <cstdint>

namespace touchline {

struct GuideInput {
    const Scene* scene = nullptr;  // scene that is felt; null: none
    Position handle;
    Velocity velocity;
    bool is_live = false;  // force may act in full: a hand holds the handle, no change is under way
    GuidanceCommand command;
};

inline constexpr double most_guide_N = 1.0;

class Guidance {
  public:
    /// Advances one tick of dt_s > 0. The force is at most 1 N and grows from zero in 0.3 s. A new
    /// command, force that is no longer live, or another scene stops the guidance, and its force is
    /// gone after 40 ms. A command given before force is live waits for it. Makes one query of the
    /// tree when to_line begins, else O(1).
    [[nodiscard]] Force step(const GuideInput& input, double dt_s);

    /// True while guidance force acts or is about to.
    [[nodiscard]] bool leads() const { return is_leading_ || gain_ > 0.0; }

    /// True if guidance begins as soon as force is live; until then, lines should push less than
    /// what keeps force off.
    [[nodiscard]] bool is_pending() const { return is_wanted_; }

    [[nodiscard]] const GuidanceStatus& status() const { return status_; }

    /// Another scene takes over: forgets every place on the old one.
    void leave_scene();

    /// Whether all its places are on the scene (null: none), for a copy from elsewhere.
    [[nodiscard]] bool fits(const Scene* scene) const;

  private:
    void take(const GuidanceCommand& command);
    void end(GuidancePhase how);
    void begin(const GuideInput& input);
    void begin_tour(const Scene& scene);
    void begin_to_line(const Scene& scene, Position handle);
    void lead(const GuideInput& input, double dt_s);
    void go_on(const Scene& scene);
    void rest(const Scene& scene);
    [[nodiscard]] bool is_at_end() const;
    void tell_phase(bool is_held_back);
    [[nodiscard]] Force pull(const GuideInput& input, Velocity ahead) const;

    bool is_first_ = true;    // no command has come yet
    bool is_wanted_ = false;  // begins as soon as possible
    bool is_leading_ = false;
    bool is_approaching_ = false;  // on a tour: straight to where an outline begins
    GuidanceCommand command_;
    GuidanceStatus status_;
    LeadingPoint point_;
    int next_leg_ = 0;  // of a tour
    int end_leg_ = 0;
    double pause_s_ = 0.0;  // left
    double rate_ = 0.0;     // of the point's own time, 0 ... 1: it waits for the hand
    double gain_ = 0.0;     // of the force
};

}  // namespace touchline
