// Leads the hand by the handle: along the outlines, to a place, or to the nearest line. The force
// pulls towards a point that goes ahead and waits for the hand; it lets go within 50 ms. The frame
// of the drawing area pushes the hand back beyond the edge, so that there is always a place to
// begin from. The shakes by which the handle speaks are a table with a player. Threads: one, the
// servo's. Plain values; no allocation, lock, clock or log.
#pragma once

#include "config/types/guidance.h"
#include "config/types/tactile_map.h"
#include "config/types/vec2.h"
#include "haptics/collision/scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace touchline {

struct FramePush {
    Force force;
    double stored_J = 0.0;
};

inline constexpr double frame_N_per_m = 500.0;
inline constexpr double most_frame_N = 1.5;  // per side: a hand that wants out comes out

/// A spring beyond each side of the area, no stiffer than stiffness_N_per_m > 0. O(1).
[[nodiscard]] inline FramePush frame_push(const Area& area, Position handle,
                                          double stiffness_N_per_m) {
    const double k_N_per_m = std::min(stiffness_N_per_m, frame_N_per_m);
    FramePush push;
    const auto side = [&](double at_m, double half_m) {
        const double depth_m = std::max(0.0, std::abs(at_m) - half_m);
        const double force_N = std::min(k_N_per_m * depth_m, most_frame_N);
        push.stored_J += force_N * (depth_m - 0.5 * force_N / k_N_per_m);
        return -std::copysign(force_N, at_m);
    };
    push.force.x = side(handle.x, 0.5 * area.width_m);
    push.force.y = side(handle.y, 0.5 * area.height_m);
    return push;
}

/// Returns the place in the area that is nearest to p.
[[nodiscard]] inline Position within(const Area& area, Position p) {
    return {std::clamp(p.x, -0.5 * area.width_m, 0.5 * area.width_m),
            std::clamp(p.y, -0.5 * area.height_m, 0.5 * area.height_m)};
}

/// Each ramp is the one of least jerk between rest and an even speed, v (3 u^2 - 2 u^3). A way too
/// short for the speed gets a lower one.
class SpeedProfile {
  public:
    SpeedProfile() = default;

    /// length_m >= 0, speed_m_per_s > 0.
    SpeedProfile(double length_m, double speed_m_per_s)
        : length_m_(length_m), speed_m_per_s_(std::min(speed_m_per_s, length_m / ramp_s)) {}

    [[nodiscard]] double duration_s() const {
        return speed_m_per_s_ > 0.0 ? length_m_ / speed_m_per_s_ + ramp_s : 0.0;
    }

    /// Returns the way covered after t_s, for any t_s.
    [[nodiscard]] double gone_m(double t_s) const {
        const double left_s = duration_s() - t_s;
        if (!(left_s > 0.0)) return length_m_;
        if (left_s < ramp_s) return length_m_ - ramp_m(left_s);
        if (t_s < ramp_s) return ramp_m(std::max(0.0, t_s));
        return speed_m_per_s_ * (t_s - 0.5 * ramp_s);
    }

  private:
    static constexpr double ramp_s = 0.3;

    [[nodiscard]] double ramp_m(double t_s) const {
        const double u = t_s / ramp_s;
        return speed_m_per_s_ * ramp_s * u * u * u * (1.0 - 0.5 * u);
    }

    double length_m_ = 0.0;
    double speed_m_per_s_ = 0.0;
};

/// The point that leads the hand: straight to a place, or along the outlines up to the next resting
/// place.
class LeadingPoint {
  public:
    /// Puts the point at p, at rest.
    void put(Position p) { *this = LeadingPoint(p); }

    /// Goes straight from where it is.
    void go_straight(Position to, double speed_m_per_s);

    /// Goes from the start of that leg, where it must be, to the next rest.
    void go_along(const Scene& scene, int leg, double speed_m_per_s);

    /// Lets dt_s >= 0 of its own time go by. Passes at most 64 edges; the rest of the way follows
    /// later. `scene` is that of go_along().
    void step(const Scene& scene, double dt_s);

    [[nodiscard]] bool has_arrived() const { return has_arrived_; }

    [[nodiscard]] Position position() const { return position_; }

    /// The leg that it is on, or was on last; -1: none.
    [[nodiscard]] int leg() const { return leg_; }

    /// Whether its places exist in the scene, for a copy from elsewhere.
    [[nodiscard]] bool fits(const Scene& scene) const;

    LeadingPoint() = default;

  private:
    explicit LeadingPoint(Position p) : position_(p), from_(p), to_(p) {}

    void walk(const Scene& scene, double way_m);

    Position position_;
    Position from_, to_;  // of a straight way
    SpeedProfile profile_;
    double t_s_ = 0.0;
    double gone_m_ = 0.0;
    bool has_arrived_ = true;
    bool is_straight_ = true;
    int leg_ = -1;
    int point_ = 0;         // start of the edge that it is on
    double on_edge_m_ = 0;  // gone on that edge
};

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

/// Pulses of a force that swings to and fro along a line: whole swings of a cosine under a bell, so
/// that neither its sum nor its moment in time pushes the hand anywhere.
struct PatternRow {
    HandlePattern pattern = HandlePattern::none;
    int pulses = 0;
    Direction direction;
    double frequency_Hz = 0.0;
    double peak_N = 0.0;  // <= 1
    int swings = 0;       // in a pulse, >= 2
    double gap_s = 0.0;   // after each pulse
};

/// One row for every pattern except none. Any two differ in at least two of: pulses, direction (by
/// 45 degrees and more), frequency (by half and more).
[[nodiscard]] std::span<const PatternRow> pattern_rows();

/// Returns its force at t_s since it began; zero before and after. O(1).
[[nodiscard]] Force force_at(const PatternRow& row, double t_s);

[[nodiscard]] double duration_s(const PatternRow& row);

/// Plays one pattern at a time. A new pattern replaces the playing one, which ends in 20 ms. A
/// pattern asked for while force is not live is left out: late, it would mean something else.
class PatternPlayer {
  public:
    /// Advances one tick of dt_s > 0.
    [[nodiscard]] Force step(const PatternCommand& command, bool is_live, double dt_s);

    /// The serial of the last command that was begun or left out.
    [[nodiscard]] std::uint32_t serial() const { return serial_; }

    /// Whether the playing pattern is in the table, for a copy from elsewhere.
    [[nodiscard]] bool is_sound() const;

  private:
    bool is_first_ = true;
    std::uint32_t known_ = 0;  // the last one received
    std::uint32_t serial_ = 0;
    HandlePattern wanted_ = HandlePattern::none;  // after the one that plays
    HandlePattern playing_ = HandlePattern::none;
    bool is_ending_ = false;
    double t_s_ = 0.0;
    double gain_ = 0.0;
};

}  // namespace touchline
