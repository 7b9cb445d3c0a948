// l_cost: the finest level that the tick has time for. It comes from counted work, not from time,
// so that a run can be repeated. Threads: one, the servo's. No allocation, no clock.
#pragma once

#include "haptics/contact/contact_machine.h"
#include "haptics/resolution/level_rule.h"

namespace touchline {

/// The work of one tick's contact.
struct Work {
    int boxes = 0;        // opened
    bool is_cut = false;  // a limit of the step ended it: part of the motion is carried over
};

[[nodiscard]] Work work_of(const ContactReport& report);

/// Returns the number of boxes worth three tenths of a period, the share of a tick that contact may
/// take.
[[nodiscard]] int affordable_boxes(double period_s);

/// Coarsens at once to the level above the rendered one if a tick took more than is affordable, or
/// if each of the last four was cut, however few boxes they opened. What a single tick leaves over,
/// the next one makes up. Refines one level at a time, after at least half a second, and only if
/// none of the last 64 ticks was cut and the largest of them stays affordable if each finer level
/// takes twice the work of the one above. If a refinement does not last, the next waits twice as
/// long, up to 8 s.
class CostTerm {
  public:
    /// period_s > 0 is the servo's.
    explicit CostTerm(double period_s);

    /// Advances one tick. The work was done at `rendered_level`, since a change of level may take
    /// several ticks. Returns level().
    double step(const Work& work, double rendered_level);

    /// The level for the next tick: whole, >= 0. A level coarser than the scene's coarsest means
    /// that not even that one is affordable.
    [[nodiscard]] double level() const { return level_; }

    /// Whether a copy made from bytes may be stepped.
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
