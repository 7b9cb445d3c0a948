// The whole shipped loop: the servo step drives the simulated pantograph, with the delay, the hand
// and the faults of real ones, on a virtual clock. Other controllers can take its place.
// Threads: pure functions.
#pragma once

#include "haptics/collision/scene.h"
#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/pantograph/profile.h"
#include "tests/lab/stability/loop_controllers.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace touchline::stability {

/// Returns a number evenly distributed in [0, 1), by SplitMix64. It depends only on a seed and a
/// counter: the same in any order, on any machine.
[[nodiscard]] constexpr double even_noise(std::uint64_t seed, std::uint64_t counter) {
    std::uint64_t z = seed * 0xd1342543de82ef95U + (counter + 1) * 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
}

/// What the servo does not know of its device.
struct Faults {
    double arm_1_scale_error = 0.0;  // relative, of one encoder
    double friction_factor = 1.0;    // of the profile's Coulomb friction
    double torque_noise = 0.0;       // even, relative, of each motor's torque each tick
    double late_share = 0.0;         // of ticks that come 5 ms late; those between are missed
    std::uint64_t seed = 1;
};

struct ShippedLoop {
    DeviceProfile profile;
    double period_s = 1e-3;
    double delay_s = 0.0;  // transport, unseen by the servo
    HandModel hand;
    Faults faults;
    double stiffness_N_per_m = 500.0;                    // asked for; the servo limits it
    double radius_m = 0.0;                               // of the proxy
    std::function<double(double t_s)> level{};           // wanted; without one 0
    std::function<const Scene*(double t_s)> scene_at{};  // felt; without one the controller's
};

/// One value per tick that took place.
struct LoopTrace {
    std::vector<double> time_s;
    std::vector<Position> tip;    // true
    std::vector<Position> place;  // proxy as the servo sees it, so off by an arm's scale error
    std::vector<Force> force;     // told to the motors, on the hand
    double least_gain = 1.0;      // the stability monitor's; 1 if it never cut
    double generated_J = 0.0;     // energy that the delayed force gave the tip
    double bound_J = 0.0;         // limit of that: sum of K |dx|^2 / 2 (1 + 2 t_d/T) + K Delta |dx|
};

/// Starts where the path starts, with force off; the servo arms for 0.2 s and ramps for 0.5 s.
[[nodiscard]] LoopTrace run(const ShippedLoop& loop, const Scene& scene,
                            std::shared_ptr<const IntendedPath> path, double span_s);

/// Does the same with another controller, which must be new.
[[nodiscard]] LoopTrace run(const ShippedLoop& loop, LoopController& controller,
                            std::shared_ptr<const IntendedPath> path, double span_s);

/// Returns the largest extent along an axis of the tip's motion from `from_s` on.
[[nodiscard]] double extent_m(const LoopTrace& trace, double from_s);

/// Returns the root mean square about the mean from `from_s` on.
[[nodiscard]] double ripple_N(const LoopTrace& trace, double from_s);

}  // namespace touchline::stability
