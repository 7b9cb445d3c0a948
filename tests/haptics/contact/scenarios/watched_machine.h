// The production contact machine, measured for everything that must hold at every step, whatever
// the geometry.
#pragma once

#include "haptics/contact/contact_machine.h"
#include "tests/haptics/contact/judge.h"
#include "tests/haptics/contact/scenarios/plant.h"

#include <vector>

namespace touchline::scenarios {

/// Let h be the hand, p the proxy and F = K (p - h). While the curve is fixed and no step makes |h
/// - p| grow, F_k . (h_{k+1} - h_k) <= U_k - U_{k+1} + 1/2 K |h_{k+1} - h_k|^2, where U is the
/// spring's energy. So the work of the wall on the hand is at most the sum of the last term over
/// the steps of contact, the entry included. The same holds with motors that saturate: their energy
/// is convex in p - h, and as smooth.
struct Watch {
    double farthest_growth_m = 0.0;  // of |h - p| by a step that keeps the level
    double work_J = 0.0;             // done on the hand
    double allowed_J = 0.0;          // the sum above
    double switched_J = 0.0;         // energy that level changes added to the spring
    int level_changes = 0;           // steps in which the rendered level changed
    int crossings = 0;   // steps whose way met a line, by exact predicates; at level 0 only
    int side_flips = 0;  // steps on the other side of the same outline than in the step before
};

class WatchedMachine {
  public:
    /// Starts free at `start`. `scene` must outlive the machine.
    WatchedMachine(const Scene& scene, const CommonSetUp& set_up, Position start,
                   double level = 0.0);

    ContactReport step(Position handle, double level = 0.0);

    [[nodiscard]] const ContactMachine& machine() const { return machine_; }

    [[nodiscard]] const Watch& watch() const { return watch_; }

  private:
    void book_energy(Position handle, Force force);

    ContactSettings settings_;
    double motors_N_;
    Judge judge_;
    ContactMachine machine_;
    std::vector<Position> path_;
    Watch watch_;
    bool has_last_ = false;  // whether these are set:
    Position last_handle_;
    Force last_force_;
    ContactReport last_report_;
};

/// Expects no crossing, no growth (1e-12 m) and no more work than allowed; records the watch as
/// properties of the test.
void expect_sound(const Watch& watch);

}  // namespace touchline::scenarios
