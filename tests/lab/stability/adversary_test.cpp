// Energy that a wall gives to a hand that is moved, not free: the adversaries of the literature.
#include "tests/lab/stability/limits.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace touchline::stability {
namespace {

/// The worst of the motions tried.
struct Worst {
    double coulomb_N = 0.0;  // least friction that makes all of them lose energy
    int periods = 0;         // of sampling, in one period of the motion
    double amplitude_m = 0.0;
};

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

/// Returns the damping (Ns/m) that just takes the energy the sampled, delayed spring gives while a
/// hand presses at constant speed to a depth and back: mean over 64 phases of the sampling, 10 mm,
/// 0.1 m/s.
double damping_of_a_press(double stiffness_N_per_m, double period_s, double delay_s) {
    constexpr int phases = 64;
    double work_J = 0.0;
    for (int i = 0; i < phases; ++i) {
        work_J += work_of_a_press_J(stiffness_N_per_m, period_s, delay_s, (i + 0.5) / phases);
    }
    return work_J / phases / (2.0 * press_depth_m * press_speed_m_per_s);
}

/// Tries triangles around an encoder tick, in step with the sampling: periods of 2 to 8 samples,
/// amplitudes from a thousandth of an encoder step to 20. b: the device's damping.
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

TEST(Adversary, APressGivesWhatSamplingAndDelayCost) {
    struct Row {
        double period_s, delay, damping;  // reference
    };

    for (const Row& row :
         {Row{1e-3, 0.0, 0.4975}, Row{1e-3, 1.0, 1.4825}, Row{2.5e-4, 0.0, 0.1248}}) {
        EXPECT_NEAR(damping_of_a_press(1000.0, row.period_s, row.delay * row.period_s), row.damping,
                    0.0005 * row.damping);
    }
}

TEST(Adversary, AQuantiserNeedsHalfAStepOfForceAsFriction) {
    struct Row {
        double stiffness, period_s, encoder_step_m, damping;  // of K T/2
    };

    for (const Row& row : {Row{1000, 1e-3, 20e-6, 1.0}, Row{1000, 1e-3, 20e-6, 2.0},
                           Row{2000, 2e-3, 90e-6, 1.0}, Row{500, 2e-3, 41e-6, 1.2}}) {
        const double b = row.damping * 0.5 * row.stiffness * row.period_s;
        const Worst worst = worst_triangle(row.stiffness, row.period_s, row.encoder_step_m, b);
        EXPECT_NEAR(worst.coulomb_N, 0.5 * row.stiffness * row.encoder_step_m,
                    0.005 * worst.coulomb_N);
        EXPECT_NEAR(quantiser_stiffness(worst.coulomb_N, row.encoder_step_m), row.stiffness,
                    0.005 * row.stiffness);
    }
}

TEST(Adversary, FrictionCannotStandInForDamping) {
    const Worst worst = worst_triangle(1000.0, 1e-3, 20e-6, 0.9 * 0.5);
    EXPECT_NEAR(worst.coulomb_N / 0.01, 2.87, 0.02);
    EXPECT_GT(worst.amplitude_m, 18 * 20e-6);
}

}  // namespace
}  // namespace touchline::stability
