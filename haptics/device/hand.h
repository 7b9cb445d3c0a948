// Simulated hands: a mass on a spring and damper that follow an intended path, held rigidly or
// through the skin.
// Threads: values; each intended path states its own rule.
#pragma once

#include "config/types/vec2.h"

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

namespace touchline {

struct HandModel {
    /// Between the tip and the hand's mass. Without it the hand holds the tip rigidly.
    struct Skin {
        double stiffness_N_per_m = 0.0;
        double damping_Ns_per_m = 0.0;
    };

    double mass_kg = 0.0;
    double damping_Ns_per_m = 0.0;   // to the intended path
    double stiffness_N_per_m = 0.0;  // to the intended path
    std::optional<Skin> skin;        // needs mass_kg > 0
};

inline constexpr HandModel no_hand{};                            // H0: the hand lets go
inline constexpr HandModel light_hand{0.03, 1.0, 50.0, {}};      // H1: a finger, a loose pen
inline constexpr HandModel normal_hand{0.10, 3.0, 300.0, {}};    // H2: a pen grip
inline constexpr HandModel relaxed_arm{0.554, 6.45, 135.0, {}};  // H3
inline constexpr HandModel stiff_arm{0.4, 12.0, 1000.0, {}};     // H4

/// Where the hand means to be.
struct Intention {
    Position position;
    Velocity velocity;
    double angle_rad = 0.0;  // if the handle turns
    double turn_rad_per_s = 0.0;
};

class IntendedPath {
  public:
    virtual ~IntendedPath() = default;
    /// Returns the intention in W, at t_s >= 0. No allocation, no lock.
    [[nodiscard]] virtual Intention at(double t_s) const = 0;

  protected:
    IntendedPath() = default;
    IntendedPath(const IntendedPath&) = default;
    IntendedPath(IntendedPath&&) = default;
    IntendedPath& operator=(const IntendedPath&) = default;
    IntendedPath& operator=(IntendedPath&&) = default;
};

/// Goes straight from way point to way point, and stands still before the first and after the last.
/// Threads: immutable. at() is O(log n).
class WaypointPath final : public IntendedPath {
  public:
    struct Waypoint {
        double t_s = 0.0;  // strictly increasing
        Position position;
        double angle_rad = 0.0;
    };

    /// Takes at least one way point.
    explicit WaypointPath(std::vector<Waypoint> waypoints) : waypoints_(std::move(waypoints)) {}

    [[nodiscard]] Intention at(double t_s) const override;

  private:
    std::vector<Waypoint> waypoints_;
};

/// A hand led by a pointer: it means to be at the place it was told last.
/// Threads: move_to() from any one thread, at() from any other; lock-free.
class MouseHand final : public IntendedPath {
  public:
    explicit MouseHand(Position start) { move_to(start); }

    /// In W; rounded to 10 nm within 0.1 m of the origin. A position that is not finite is ignored.
    void move_to(Position position);

    [[nodiscard]] Intention at(double t_s) const override;

  private:
    // Both coordinates as floats in one word, so that they change together.
    std::atomic<std::uint64_t> packed_{0};
};

}  // namespace touchline
