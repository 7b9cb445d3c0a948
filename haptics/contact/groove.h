// Groove, ridge and stay: the hand is tied to a line, or pushed off it, on the same rendered curve
// as the wall. Threads: one, the servo's. No allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/contact/attachment.h"
#include "haptics/contact/capture_law.h"
#include "haptics/contact/energy_account.h"
#include "haptics/contact/proxy_state.h"
#include "haptics/contact/rendered_outlines.h"

namespace touchline {

/// The result of a tick.
struct GrooveForce {
    Force force;
    Attachment at;  // the line that has the greater share of the force; none: no line is near
    Position p_WA;  // of the attachment; the handle where there is none
    double stored_J = 0.0;    // in the laws
    Side side = Side::left;   // of that line, where the handle is
    int boxes = 0;            // opened
    bool is_complete = true;  // false: the budget ended before all nearer lines were looked at
};

/// Ties the hand to one attachment, which slides along its line towards the hand. A line that is
/// nearer by 0.2 mm takes over: for 30 ms both share the force, longer if it would change by more
/// than 0.015 N a tick. In ridge mode, both lines keep a share by their distances while both are
/// near, so that a hand between two lines rests.
///
/// Work on the hand: let U be the stored energy of the laws (capture_law.h) and F the force of the
/// tick before. No tick leaves more than U - F dh + 1/2 K |dh|^2 plus what the account covers
/// (energy_account.h: what lines have dissipated, and 0.1 mW). If sliding, handing over, or a
/// change of level or stiffness would leave more, the strength of all is reduced, and comes back as
/// it is covered. So no closed loop of the hand gains more than the sum of 1/2 K |dh|^2 and 0.1 mW.
class Groove {
  public:
    /// Advances one tick of `dt_s` > 0. The level of `outlines` moves towards `level`: at once
    /// while no line is near, else by at most half an octave and only so far that the force changes
    /// by 0.0075 N. The attachments keep their parameters meanwhile, and their slide is limited in
    /// the same way. Makes at most one query, and none while the attachment is nearer than 0.2 mm.
    [[nodiscard]] GrooveForce step(RenderedOutlines& outlines, double level, Position handle,
                                   const ContactSettings& settings, const Budget& budget,
                                   double dt_s);

    /// Whether its attachments lie on these outlines.
    [[nodiscard]] bool fits(const RenderedOutlines& outlines) const {
        return (!now_.exists() || outlines.has(now_.segment)) &&
               (!before_.exists() || outlines.has(before_.segment));
    }

  private:
    /// A line's part in the force, before shares and strength. Without a line it is as at the
    /// capture width.
    struct Part {
        Force force;
        double energy_J = 0.0;
        double distance_m = 0.0;
    };

    [[nodiscard]] bool is_tied() const { return now_.exists() || before_.exists(); }

    void change_level(RenderedOutlines& outlines, double level, const CaptureLaw& law);
    void slide(RenderedOutlines& outlines, Position handle, const CaptureLaw& law, double longest_m,
               double longest_hop_m);
    void look_for_nearer(RenderedOutlines& outlines, Position handle, const CaptureLaw& law,
                         const Budget& budget, double most_N, GrooveForce& result);
    void take_over(const Attachment& found);
    [[nodiscard]] Part part_of(RenderedOutlines& outlines, const Attachment& at, Position handle,
                               const CaptureLaw& law) const;
    void shift(const Part& now, const Part& before, double dt_s);
    [[nodiscard]] double wanted_share(const Part& now, const Part& before) const;
    void store(double energy_J, Position moved, double stiffness_N_per_m, double dt_s);

    Attachment now_, before_;  // either may be none
    double share_ = 1.0;       // of now_ in the force; before_ has the rest
    bool is_crowded_ = false;  // a third line is nearer than both
    Mode mode_ = Mode::groove;
    double strength_ = 1.0;  // of both, 0 ... 1
    EnergyAccount account_;
    double energy_J_ = 0.0;  // stored after the last tick
    Force force_;            // of the last tick
    Position handle_;        // of the last tick
    bool is_fresh_ = true;   // no tick yet
};

}  // namespace touchline
