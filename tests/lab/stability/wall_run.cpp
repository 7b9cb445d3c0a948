#include "tests/lab/stability/wall_run.h"

#include <algorithm>
#include <cmath>

namespace touchline::stability {

double stiffness_at(const StiffnessGrid& grid, int index) {
    return index < 0 ? 0.0 : grid.from_N_per_m * std::pow(grid.step, index);
}

double bisected_stiffness(const StiffnessGrid& grid, const StiffnessTest& holds) {
    int good = -1;
    int bad = grid.count;
    while (bad - good > 1) {
        const int middle = (good + bad) / 2;
        (holds(stiffness_at(grid, middle)) ? good : bad) = middle;
    }
    return stiffness_at(grid, good);
}

double scanned_stiffness(const StiffnessGrid& grid, const StiffnessTest& holds) {
    int good = -1;
    while (good + 1 < grid.count && holds(stiffness_at(grid, good + 1))) ++good;
    return stiffness_at(grid, good);
}

namespace {
constexpr double far_away_m = 10.0;
}

double quantised(double x_m, double encoder_step_m) {
    if (!(encoder_step_m > 0.0)) return x_m;
    return std::floor(x_m / encoder_step_m + 1e-12) * encoder_step_m;
}

WallTrace run(const WallLoop& loop, const Excitation& excitation, const ForceLaw& force_law,
              double span_s) {
    const auto samples = static_cast<int>(std::lround(span_s / loop.period_s));
    const double h_s = loop.period_s / loop.substeps;
    const auto delay_substeps = static_cast<int>(std::lround(loop.delay_s / h_s));
    TipDynamics dynamics(loop.tip, loop.hand, {});
    dynamics.stop_at({excitation.start_m, 0.0});
    dynamics.set_velocity({excitation.speed_m_per_s, 0.0});
    WallTrace trace;
    trace.x_m.reserve(static_cast<std::size_t>(samples));
    trace.force_N.reserve(static_cast<std::size_t>(samples));
    double acting_N = excitation.acting_N;
    for (int k = 0; k < samples; ++k) {
        const double sampled_m = dynamics.tip().position.x;
        if (!(std::abs(sampled_m) < far_away_m)) break;
        const double wanted_N = force_law(quantised(sampled_m, loop.encoder_step_m));
        trace.x_m.push_back(sampled_m);
        trace.force_N.push_back(std::clamp(wanted_N, -loop.motors_N, loop.motors_N));
        const double push_N =
            k * loop.period_s < excitation.release_at_s ? excitation.push_N : excitation.released_N;
        for (int i = 0; i < loop.substeps; ++i) {
            const int sent = k * loop.substeps + i - delay_substeps;
            if (sent >= 0) acting_N = trace.force_N[static_cast<std::size_t>(sent / loop.substeps)];
            const double before_m = dynamics.tip().position.x;
            dynamics.step({acting_N + push_N, 0.0}, {}, h_s);
            trace.work_J += acting_N * (dynamics.tip().position.x - before_m);
        }
    }
    if (trace.x_m.size() < static_cast<std::size_t>(samples)) {
        trace.x_m.push_back(std::numeric_limits<double>::infinity());
    }
    return trace;
}

double peak_to_peak_m(const WallTrace& trace, double from_share, double to_share) {
    if (!std::isfinite(trace.x_m.back())) return std::numeric_limits<double>::infinity();
    const auto place = [&](double share) {
        return trace.x_m.begin() + std::lround(share * static_cast<double>(trace.x_m.size()));
    };
    const auto [low, high] = std::minmax_element(place(from_share), place(to_share));
    return *high - *low;
}

double largest_step_N(const WallTrace& trace) {
    double largest = 0.0;
    for (std::size_t k = 1; k < trace.force_N.size(); ++k) {
        largest = std::max(largest, std::abs(trace.force_N[k] - trace.force_N[k - 1]));
    }
    return largest;
}

}  // namespace touchline::stability
