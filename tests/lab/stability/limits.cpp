#include "tests/lab/stability/limits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace touchline::stability {

namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int frequencies = 4000;
}  // namespace

double colgate_stiffness(double b_Ns_per_m, double wall_damping_Ns_per_m, double period_s) {
    return 2.0 * (b_Ns_per_m - std::abs(wall_damping_Ns_per_m)) / period_s;
}

double linear_stiffness(double b_Ns_per_m, double wall_damping_Ns_per_m, double period_s,
                        double delay_s) {
    return (b_Ns_per_m + wall_damping_Ns_per_m) / (0.5 * period_s + delay_s);
}

double quantiser_stiffness(double coulomb_N, double encoder_step_m) {
    return encoder_step_m > 0.0 ? 2.0 * coulomb_N / encoder_step_m : infinity;
}

double calmed_speed_m_per_s(double stiffness_N_per_m, double b_Ns_per_m, double coulomb_N,
                            double period_s, double delay_s) {
    const double excess = stiffness_N_per_m * (0.5 * period_s + delay_s) - b_Ns_per_m;
    return excess > 0.0 ? 4.0 * coulomb_N / (std::numbers::pi * excess) : infinity;
}

double calmed_stiffness(double speed_m_per_s, double b_Ns_per_m, double coulomb_N, double period_s,
                        double delay_s) {
    const double excess = 4.0 * coulomb_N / (std::numbers::pi * speed_m_per_s);
    return (excess + b_Ns_per_m) / (0.5 * period_s + delay_s);
}

Transfer damped_spring(double stiffness_N_per_m, double wall_damping_Ns_per_m, double period_s,
                       double share) {
    return [=](std::complex<double> z_inverse) {
        const auto low_pass = share / (1.0 - (1.0 - share) * z_inverse);
        return stiffness_N_per_m + wall_damping_Ns_per_m / period_s * (1.0 - z_inverse) * low_pass;
    };
}

Transfer slope_damped_spring(double stiffness_N_per_m, double wall_damping_Ns_per_m,
                             double period_s, int periods) {
    return [=](std::complex<double> z_inverse) {
        std::complex<double> then = 1.0;
        for (int i = 0; i < periods; ++i) then *= z_inverse;
        return stiffness_N_per_m + wall_damping_Ns_per_m / (periods * period_s) * (1.0 - then);
    };
}

double least_damping_Ns_per_m(const Transfer& wall, double period_s, double delay_s) {
    const double whole_periods = std::floor(delay_s / period_s + 1e-9);
    const double part = std::max(0.0, delay_s / period_s - whole_periods);
    double least = 0.0;
    for (int i = 1; i <= frequencies; ++i) {
        const double theta = std::numbers::pi * i / frequencies;
        const auto z_inverse = std::polar(1.0, -theta);
        const auto work = 0.5 * period_s / (1.0 - std::cos(theta)) * (1.0 - z_inverse) *
                          wall(z_inverse) * std::polar(1.0, -theta * whole_periods);
        const auto in_phase = work * (1.0 - part + part * z_inverse);
        const double across = std::norm(work) - in_phase.imag() * in_phase.imag();
        // Equal to the real part at whole periods, where the difference would only be rounding.
        const double size =
            part < 1e-9 ? std::abs(in_phase.real()) : std::sqrt(std::max(0.0, across));
        least = std::max(least, 0.5 * (in_phase.real() + size));
    }
    return least;
}

double passive_stiffness(const std::function<Transfer(double stiffness)>& wall, double b_Ns_per_m,
                         double period_s, double delay_s) {
    double passive = 0.0;
    double active = 1e6;
    if (least_damping_Ns_per_m(wall(passive), period_s, delay_s) > b_Ns_per_m) return 0.0;
    for (int halving = 0; halving < 30; ++halving) {
        const double middle = 0.5 * (passive + active);
        const bool is_passive =
            least_damping_Ns_per_m(wall(middle), period_s, delay_s) <= b_Ns_per_m;
        (is_passive ? passive : active) = middle;
    }
    return passive;
}

}  // namespace touchline::stability
