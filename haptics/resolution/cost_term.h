// l_cost: the finest level that the tick has time for, from work that was counted, not timed, so
// that a run can be repeated. Threads: one, the servo's. No allocation, no clock.
#pragma once

#include "haptics/contact/contact_machine.h"
#include "haptics/resolution/peak_hold.h"

namespace touchline {

/// What the contact of one tick took.
struct Work {
    int boxes = 0;        // opened
    bool is_cut = false;  // a limit of the step ended it: part of the motion is carried over
};

[[nodiscard]] Work work_of(const ContactReport& report);

/// Boxes worth three tenths of a period, the share of a tick that contact may take.
[[nodiscard]] int affordable_boxes(double period_s);

/// Coarsens at once when a tick took more than is affordable, or when each of the last four was
/// cut, however few boxes they opened: to the level above the one that was rendered. What a single
/// tick leaves over is made up by the next. Refines one level at a time, after half a second at
/// least, and only if none of the last 64 ticks was cut and the most that any of them took stays
/// affordable when each level down to there takes twice what the one above takes. Where a
/// refinement does not last, the next waits twice as long, up to 8 s.
class CostTerm {
  public:
    /// period_s > 0: of the servo.
    explicit CostTerm(double period_s);

    /// One tick. `rendered_level` is the one that the work was done at: a change of level may take
    /// several ticks. Returns level().
    double step(const Work& work, double rendered_level);

    /// Whole, >= 0, for the next tick. Coarser than the scene's coarsest: not even that one is
    /// affordable.
    [[nodiscard]] double level() const { return level_; }

    /// Whether a copy from bytes may be stepped.
    [[nodiscard]] bool is_sound() const { return recent_.is_sound(); }

  private:
    void coarsen(double rendered_level);
    void refine();
    [[nodiscard]] bool can_refine(double most_boxes, double rendered_level) const;

    double period_s_;
    double affordable_;  // boxes a tick
    PeakHold recent_;    // boxes
    double level_ = 0.0;
    double wait_s_;  // before the next refinement
    double since_change_s_ = 0.0;
    bool is_refined_ = false;  // by the last change
    int cut_in_a_row_ = 0;     // ticks, since the last change
};

}  // namespace touchline
