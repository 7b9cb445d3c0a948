// The simulated plant of the stability scenarios and what it moves on: one mass on a hand's spring
// and damper with Coulomb friction, intended paths, and scenes whose level 0 is their own vertices.
#pragma once

#include "config/types/vec2.h"
#include "haptics/collision/scene.h"
#include "haptics/contact/proxy_state.h"
#include "haptics/device/simulated/simulated_pantograph.h"
#include "tests/haptics/tick.h"

#include <functional>
#include <limits>
#include <vector>

namespace touchline::scenarios {

using std::numbers::pi;
inline constexpr double mm = 1e-3;
inline constexpr int substeps = 8;  // integration steps per tick

/// The scenarios' common set-up: K = 1000 N/m, no friction on the line, a disc of 50 um; tip and
/// hand together 0.15 kg, 0.1 + 3 N s/m, 300 N/m, 0.05 N of Coulomb friction; no delay.
struct CommonSetUp {
    ContactSettings contact{Mode::wall, 1000.0, 0.0, 5e-5, 0.003};
    TipParameters tip{0.05, 0.1, 0.05};
    HandModel hand = normal_hand;
    double motors_N = std::numeric_limits<double>::infinity();  // the most that they give
};

/// Returns what the motors make of a contact force: the same direction, at most their limit.
[[nodiscard]] Force limited(Force force, double motors_N);

using Trajectory = std::function<Intention(double t_s)>;

struct Waypoint_mm {
    double t_s, x_mm, y_mm;
};

/// Returns a path of straight stretches, at rest at t = 0.
[[nodiscard]] Trajectory through(const std::vector<Waypoint_mm>& waypoints);

/// The hand of S01: 15 mm down onto y = 0 and 5 mm further, 60 mm along it at 100 mm/s, and off.
[[nodiscard]] Trajectory press_and_slide();

/// Starts tip and hand where the hand means to be at t = 0, as fast as it means to be.
class Plant {
  public:
    Plant(const CommonSetUp& set_up, const Trajectory& trajectory);

    [[nodiscard]] Position position() const { return dynamics_.tip().position; }

    /// Advances from tick k to tick k + 1 with the force held.
    void tick(std::size_t k, Force force);

  private:
    Trajectory trajectory_;
    TipDynamics dynamics_;
};

struct Polyline {
    std::vector<Position> points_mm;
    bool is_closed = false;
};

/// A line from (-50, 0) to (50, 0).
[[nodiscard]] Polyline flat_line();

/// A polygon counter-clockwise about the origin, the first vertex at angle 0.
[[nodiscard]] Polyline polygon(double radius_mm, int vertices);

/// The flat line, its middle 60 mm in 100 000 pieces; one in every hundred has no length, or 1 nm.
[[nodiscard]] Polyline cut_line();

/// y = bend (0.2 mm + 0.02 / mm x^2) + shift over 40 mm in 128 edges, so that the coarsest level
/// has four.
[[nodiscard]] Polyline strand(double bend, double shift_mm, double begin_mm);

[[nodiscard]] TactileMap map_of(const std::vector<Polyline>& polylines);

/// Builds production curves through these points. Keeps every vertex, and splits edges longer than
/// the median one into collinear parts.
[[nodiscard]] Scene scene_of(const std::vector<Polyline>& polylines,
                             double radius_m = CommonSetUp{}.contact.radius_m,
                             const CurveOptions& options = {});

}  // namespace touchline::scenarios
