// What stands between the encoders and the motors of a device: the shipped servo step, and simpler
// ways to render the same lines for comparison.
// Threads: one each.
#pragma once

#include "config/types/pinned.h"
#include "haptics/device/force_device.h"
#include "haptics/pantograph/profile.h"
#include "tests/lab/stability/loop_scenarios.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace touchline::stability {

struct ControlInput {
    double time_s = 0.0;
    std::uint64_t missed_ticks = 0;
    std::optional<DeviceReading> reading;
    double level = 0.0;            // wanted
    const Scene* scene = nullptr;  // felt; null: the one that the controller was made for
};

struct ControlOutput {
    DeviceCommand command;
    Force force;        // on the hand, in W
    Position place;     // the proxy, or the handle for a renderer without one
    double gain = 1.0;  // of the stability monitor
    double stiffness_N_per_m = 0.0;
};

class LoopController : public Interface {
  public:
    virtual ControlOutput step(const ControlInput& input) = 0;
};

struct LoopParameters {
    double period_s = 1e-3;
    double stiffness_N_per_m = 500.0;  // asked for; the shipped step limits it
    double radius_m = 0.0;             // of the proxy
};

/// Makes the production servo step in walls of `scene`, which must outlive it.
[[nodiscard]] std::unique_ptr<LoopController> shipped_step(const DeviceProfile& profile,
                                                           const LoopParameters& parameters,
                                                           const Scene& scene);

struct LoopMethod {
    std::string_view name;
    int local_rate = 1;  // periods of the force per period of the geometry
    /// The scenario must outlive the controller. `parameters` are those of the force's loop.
    std::unique_ptr<LoopController> (*make)(const DeviceProfile& profile,
                                            const LoopParameters& parameters,
                                            const LoopScenario& scenario);
};

/// Returns shipped; penalty forces and the plain proxy of the bench, each as a bare spring and with
/// the shipped damping; a local model: the shipped machine's contact passed to a spring that runs
/// four times as often. All but the first give up to 3 N at once, at level 0, with a point as
/// proxy.
[[nodiscard]] std::span<const LoopMethod> loop_methods();

}  // namespace touchline::stability
