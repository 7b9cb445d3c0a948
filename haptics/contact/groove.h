// Groove, ridge and stay: the hand is tied to a line, or pushed off it, on the same rendered curve
// as the wall. The laws of the force are gradients of a potential and end smoothly at the capture
// width; the hand is tied to a bead on the outline, which slides towards the hand and stays on the
// curve when the level changes. Threads: one, the servo's. No allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/contact/proxy_state.h"
#include "haptics/contact/rendered_outlines.h"

namespace touchline {

/// The force of a line on a hand near it, by distance. d: distance, w: capture width, K: stiffness.
///   groove  K d (1 - (d/w)^2)^2 towards the line, at most 0.287 K w
///   ridge   the same, away from it
///   stay    K d (1 - (d/w)^8) towards it: stiff nearly to the edge, at most 0.676 K w, so that
///           leaving takes a push
/// 0 from w on. At K 500 N/m and w 3 mm that is 0.43 N and 1.01 N at most.
class CaptureLaw {
  public:
    explicit CaptureLaw(const ContactSettings& settings)
        : mode_(settings.mode),
          stiffness_N_per_m_(settings.stiffness_N_per_m),
          capture_m_(settings.capture_m) {}

    [[nodiscard]] double capture_m() const { return capture_m_; }

    /// The steepest slope of the force over the distance: K, and 8 K where stay gives way.
    [[nodiscard]] double steepest_N_per_m() const {
        return (mode_ == Mode::stay ? 8.0 : 1.0) * stiffness_N_per_m_;
    }

    /// Returns the pull, positive towards the line. Zero if the distance or the capture width is
    /// NaN.
    [[nodiscard]] double pull_N(double distance_m) const {
        if (!(distance_m < capture_m_)) return 0.0;
        const double spring_N = stiffness_N_per_m_ * distance_m;
        const double rest = 1.0 - square_of_share(distance_m);
        if (mode_ == Mode::stay) {
            const double share_4 = (1.0 - rest) * (1.0 - rest);
            return spring_N * (1.0 - share_4 * share_4);
        }
        return (mode_ == Mode::ridge ? -1.0 : 1.0) * spring_N * rest * rest;
    }

    /// The law's potential, >= 0: it is 0 on the line of a groove, and where a ridge ends.
    [[nodiscard]] double energy_J(double distance_m) const {
        const double q = distance_m < capture_m_ ? square_of_share(distance_m) : 1.0;
        const double scale_J = stiffness_N_per_m_ * capture_m_ * capture_m_;
        if (mode_ == Mode::stay) return scale_J * (0.5 * q - 0.1 * q * q * q * q * q);
        const double rest = (1.0 - q) * (1.0 - q) * (1.0 - q);
        return scale_J / 6.0 * (mode_ == Mode::ridge ? rest : 1.0 - rest);
    }

  private:
    [[nodiscard]] double square_of_share(double distance_m) const {
        const double share = distance_m / capture_m_;
        return share * share;
    }

    Mode mode_;
    double stiffness_N_per_m_;
    double capture_m_;
};

struct Attachment {
    SegmentRef segment;      // piece -1: none
    double parameter = 0.0;  // on the segment, 0 ... 1

    [[nodiscard]] bool exists() const { return segment.piece >= 0; }
};

[[nodiscard]] Position point_of(RenderedOutlines& outlines, const Attachment& at);

/// Slides the attachment along its outline while that brings it nearer to the hand: at most
/// `longest_m` and 256 segments. Inside a bend, where the way over the vertex first leads away from
/// the hand, it hops to the next segment's nearest point, at most `longest_hop_m` further on. The
/// distance to the hand never grows.
[[nodiscard]] Attachment slid(RenderedOutlines& outlines, Attachment at, Position handle,
                              double longest_m, double longest_hop_m);

/// Returns the attachment at the same parameter of the outline, on the curve as rendered at level
/// `to`. O(1).
[[nodiscard]] Attachment at_level(const CurveSet& curves, const Attachment& at, double from,
                                  double to);

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
/// Work on the hand: let U be the stored energy of the laws (CaptureLaw) and F the force of the
/// tick before. No tick leaves more than U - F dh + 1/2 K |dh|^2 plus what the account covers
/// (EnergyAccount: what lines have dissipated, and 0.1 mW). If sliding, handing over, or a
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
