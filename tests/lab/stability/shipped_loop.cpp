#include "tests/lab/stability/shipped_loop.h"

#include "haptics/device/simulated/simulated_cartesian.h"
#include "haptics/device/simulated/simulated_pantograph.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchline::stability {
namespace {

constexpr double late_s = 5e-3;

DeviceProfile true_device(const ShippedLoop& loop) {
    DeviceProfile device = loop.profile;
    device.mechanics.coulomb_N *= loop.faults.friction_factor;
    device.mechanics.delay_s = loop.delay_s;
    return device;
}

DeviceCommand disturbed(DeviceCommand command, const Faults& faults, std::uint64_t tick) {
    const auto factor = [&](std::uint64_t motor) {
        const double even = even_noise(faults.seed, 4 * tick + motor);
        return 1.0 + faults.torque_noise * (2.0 * even - 1.0);
    };
    const double of_x = factor(0), of_y = factor(1);
    command.torques = {of_x * command.torques.x, of_y * command.torques.y};
    command.force_D = {of_x * command.force_D.x, of_y * command.force_D.y};
    return command;
}

/// Books what the force did since the last tick, given that the force told t_d ago acted.
void book(LoopTrace& trace, const ShippedLoop& loop, double encoder_m, double stiffness) {
    const std::size_t k = trace.tip.size() - 1;
    if (k < 1) return;
    const Position moved = trace.tip[k] - trace.tip[k - 1];
    const double periods = loop.delay_s / loop.period_s;
    const auto whole = static_cast<std::size_t>(periods + 1e-9);
    const double part = std::max(0.0, periods - static_cast<double>(whole));
    const auto told = [&](std::size_t ago) { return k >= ago ? trace.force[k - ago] : Force{}; };
    const Force acted = (1.0 - part) * told(whole + 1) + part * told(whole + 2);
    trace.generated_J += dot(acted, moved);
    bool is_touching = false;
    for (std::size_t ago = 0; ago <= whole + 2; ++ago) is_touching |= told(ago) != Force{};
    if (!is_touching) return;
    const double moved_m = norm(moved);
    trace.bound_J += stiffness * moved_m * (0.5 * moved_m * (1.0 + 2.0 * periods) + encoder_m);
}

/// `device`: one in software.
template <class Device>
LoopTrace drive(const ShippedLoop& loop, Device& device, LoopController& controller,
                double span_s) {
    const double encoder_m = encoder_step_m(loop.profile);
    const auto ticks = static_cast<std::uint64_t>(std::lround(span_s / loop.period_s));
    const auto skipped = static_cast<std::uint64_t>(std::ceil(late_s / loop.period_s));
    LoopTrace trace;
    ControlInput input;
    for (std::uint64_t tick = 0; tick < ticks; ++tick) {
        if (even_noise(loop.faults.seed, 4 * tick + 2) < loop.faults.late_share) {
            tick += skipped;
            input.missed_ticks += skipped;
        }
        input.time_s = static_cast<double>(tick) * loop.period_s;
        input.reading = device.read(input.time_s);
        input.level = loop.level ? loop.level(input.time_s) : 0.0;
        if (loop.scene_at) input.scene = loop.scene_at(input.time_s);
        const ControlOutput output = controller.step(input);
        (void)device.write(disturbed(output.command, loop.faults, tick));
        trace.time_s.push_back(input.time_s);
        trace.tip.push_back(device.tip().position);
        trace.place.push_back(output.place);
        trace.force.push_back(output.force);
        trace.least_gain = std::min(trace.least_gain, output.gain);
        book(trace, loop, encoder_m, output.stiffness_N_per_m);
    }
    return trace;
}

}  // namespace

LoopTrace run(const ShippedLoop& loop, const Scene& scene, std::shared_ptr<const IntendedPath> path,
              double span_s) {
    const LoopParameters parameters{loop.period_s, loop.stiffness_N_per_m, loop.radius_m};
    const auto controller = shipped_step(loop.profile, parameters, scene);
    return run(loop, *controller, std::move(path), span_s);
}

LoopTrace run(const ShippedLoop& loop, LoopController& controller,
              std::shared_ptr<const IntendedPath> path, double span_s) {
    const double substep_s = std::min(SimulationOptions{}.substep_s, 0.25 * loop.period_s);
    if (!has_joints(loop.profile)) {
        CartesianOptions options;
        options.hand = loop.hand;
        options.substep_s = substep_s;
        SimulatedCartesian device(true_device(loop), options, std::move(path));
        return drive(loop, device, controller, span_s);
    }
    SimulationOptions options;
    options.hand = loop.hand;
    options.arm_1_scale_error = loop.faults.arm_1_scale_error;
    options.substep_s = substep_s;
    SimulatedPantograph device(true_device(loop), options, std::move(path));
    return drive(loop, device, controller, span_s);
}

double extent_m(const LoopTrace& trace, double from_s) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Position low{infinity, infinity};
    Position high = -low;
    for (std::size_t k = 0; k < trace.tip.size(); ++k) {
        if (trace.time_s[k] < from_s) continue;
        low = {std::min(low.x, trace.tip[k].x), std::min(low.y, trace.tip[k].y)};
        high = {std::max(high.x, trace.tip[k].x), std::max(high.y, trace.tip[k].y)};
    }
    return std::max(high.x - low.x, high.y - low.y);
}

double ripple_N(const LoopTrace& trace, double from_s) {
    Force sum;
    double squares = 0.0;
    double count = 0.0;
    for (std::size_t k = 0; k < trace.force.size(); ++k) {
        if (trace.time_s[k] < from_s) continue;
        sum += trace.force[k];
        squares += dot(trace.force[k], trace.force[k]);
        count += 1.0;
    }
    return std::sqrt(std::max(0.0, squares / count - dot(sum, sum) / (count * count)));
}

}  // namespace touchline::stability
