// The point that leads the hand: straight to a place, or along the outlines up to the next resting
// place. Threads: a plain value; no allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/collision/scene.h"

#include <algorithm>

namespace touchline {

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

}  // namespace touchline
