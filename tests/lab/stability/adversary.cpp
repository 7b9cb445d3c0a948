#include "tests/lab/stability/adversary.h"

#include <algorithm>
#include <cmath>

namespace touchline::stability {
namespace {

constexpr double press_depth_m = 1e-2;
constexpr double press_speed_m_per_s = 0.1;

double press_m(double t_s) {
    constexpr double turn_s = press_depth_m / press_speed_m_per_s;
    return std::max(0.0, press_depth_m - press_speed_m_per_s * std::abs(t_s - turn_s));
}

/// Returns the work of the wall on the hand. The held force is constant between updates, so the sum
/// is exact.
double work_of_a_press_J(double stiffness_N_per_m, double period_s, double delay_s, double phase) {
    constexpr double end_s = 2.0 * press_depth_m / press_speed_m_per_s;
    double work_J = 0.0;
    for (int k = -static_cast<int>(std::ceil(delay_s / period_s)) - 2;; ++k) {
        const double sampled_s = (k + phase) * period_s;
        const double from_s = sampled_s + delay_s;
        if (from_s > end_s) return work_J;
        const double moved_m = press_m(from_s + period_s) - press_m(from_s);
        work_J -= stiffness_N_per_m * press_m(sampled_s) * moved_m;
    }
}

/// Starts the hand just below a tick, far inside; it goes up in half the period and back.
double work_of_a_triangle_J(double stiffness_N_per_m, double encoder_step_m, double amplitude_m,
                            int periods) {
    const auto place_m = [&](double k) {
        return amplitude_m * (1.0 - std::abs(2.0 * k / periods - 1.0)) - 1e-9 * encoder_step_m +
               100.0 * encoder_step_m;
    };
    double work_J = 0.0;
    for (int k = 0; k < periods; ++k) {
        const double seen_m = std::floor(place_m(k) / encoder_step_m) * encoder_step_m;
        work_J -= stiffness_N_per_m * seen_m * (place_m(k + 1) - place_m(k));
    }
    return work_J;
}

}  // namespace

double damping_of_a_press(double stiffness_N_per_m, double period_s, double delay_s) {
    constexpr int phases = 64;
    double work_J = 0.0;
    for (int i = 0; i < phases; ++i) {
        work_J += work_of_a_press_J(stiffness_N_per_m, period_s, delay_s, (i + 0.5) / phases);
    }
    return work_J / phases / (2.0 * press_depth_m * press_speed_m_per_s);
}

Worst worst_triangle(double stiffness_N_per_m, double period_s, double encoder_step_m,
                     double b_Ns_per_m) {
    constexpr int amplitudes = 4000;
    constexpr double least = 1e-3;
    constexpr double most = 20.0;
    Worst worst;
    for (const int periods : {2, 3, 4, 6, 8}) {
        for (int i = 0; i < amplitudes; ++i) {
            const double amplitude_m =
                encoder_step_m * least * std::pow(most / least, i / (amplitudes - 1.0));
            const double speed = 2.0 * amplitude_m / (periods * period_s);
            const double lost_J = b_Ns_per_m * speed * 2.0 * amplitude_m;
            const double work_J =
                work_of_a_triangle_J(stiffness_N_per_m, encoder_step_m, amplitude_m, periods);
            const double coulomb_N = (work_J - lost_J) / (2.0 * amplitude_m);
            if (coulomb_N > worst.coulomb_N) worst = {coulomb_N, periods, amplitude_m};
        }
    }
    return worst;
}

}  // namespace touchline::stability
