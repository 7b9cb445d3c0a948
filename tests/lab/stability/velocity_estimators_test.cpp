// Noise and lag of the velocity estimates against the reference.

#include "tests/lab/stability/linear_loop.h"
#include "tests/lab/stability/wall_controllers.h"
#include "tests/lab/stability/wall_run.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

namespace touchline::stability {
namespace {

using Estimate = std::function<double(double x_m)>;
using Make = std::function<Estimate(double period_s, double encoder_step_m)>;

template <VelocityEstimator Estimator>
Estimate of(Estimator estimator) {
    return [estimator](double x_m) mutable { return estimator.step(x_m); };
}

Make low_pass(double cutoff_Hz) {
    return [=](double T, double) {
        return of(FilteredDifference(T, 0.0, low_pass_share(cutoff_Hz, T)));
    };
}

double down(double x_m, double encoder_step_m) {
    return std::floor(x_m / encoder_step_m) * encoder_step_m;
}

/// Returns the root mean square at constant speed over the last two thirds of 1.5 s.
double noise_m_per_s(const Make& make, double period_s, double encoder_step_m, double speed) {
    const Estimate estimate = make(period_s, encoder_step_m);
    const int count = static_cast<int>(std::lround(1.5 / period_s));
    double sum = 0.0;
    (void)estimate(0.0);
    for (int k = 1; k < count; ++k) {
        const double error = estimate(down(speed * k * period_s, encoder_step_m)) - speed;
        if (k >= count / 3) sum += error * error;
    }
    return std::sqrt(sum / (count - count / 3));
}

/// Returns the time from a stop, from 0.1 m/s within 3 ms, until the estimate is below half of that
/// for good.
double lag_s(const Make& make, double period_s, double encoder_step_m) {
    const Estimate estimate = make(period_s, encoder_step_m);
    const int count = static_cast<int>(std::lround(0.4 / period_s));
    const int middle = static_cast<int>(0.2015 / period_s);
    double x_m = 0.0;
    int last = middle - 1;
    for (int k = 0; k < count; ++k) {
        if (std::abs(estimate(down(x_m, encoder_step_m))) > 0.05 && k >= middle) last = k;
        const double t_s = k * period_s;
        const double slowing = 1.0 - (t_s - 0.2) / 0.003;
        x_m += 0.1 * std::clamp(slowing, 0.0, 1.0) * period_s;
    }
    return (last - middle + 1) * period_s;
}

TEST(VelocityEstimators, HaveTheNoiseAndLagOfTheReference) {
    const Make difference = [](double T, double) { return of(FilteredDifference(T, 0.0)); };
    const Make window = [](double T, double step_m) { return of(AdaptiveWindow(T, 0.0, step_m)); };
    const Make kalman = [](double T, double step_m) {
        return of(KalmanVelocity(T, 0.0, step_m, 5.0));
    };

    struct Row {
        std::string name;
        Make make;
        double encoder_step_m;
        double noise_mm_per_s[3];  // at 5, 51 and 213 mm/s
        double lag_ms;
    };

    const Row rows[] = {
        {"difference", difference, 10e-6, {5.0, 3.4, 4.6}, 2},
        {"LP100", low_pass(100.0), 10e-6, {1.6, 1.5, 1.7}, 3},
        {"LP30", low_pass(30.0), 10e-6, {0.5, 0.5, 0.5}, 5},
        {"FOAW16", window, 10e-6, {0.3, 0.2, 0.2}, 2},
        {"Kalman", kalman, 10e-6, {2.3, 2.5, 2.7}, 2},
        {"difference", difference, 110e-6, {23, 55, 27}, 2},
        {"LP100", low_pass(100.0), 110e-6, {12, 18, 14}, 3},
        {"LP30", low_pass(30.0), 110e-6, {5, 6, 6}, 5},
        {"FOAW16", window, 110e-6, {3.0, 3.4, 0.9}, 4},
        {"Kalman", kalman, 110e-6, {7, 5, 8}, 5},
    };
    constexpr double speeds[] = {0.0051303, 0.0513197, 0.2130117};
    for (const Row& row : rows) {
        const double last_digit = row.encoder_step_m < 50e-6 || row.name == "FOAW16" ? 0.051 : 0.51;
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(1e3 * noise_m_per_s(row.make, 1e-3, row.encoder_step_m, speeds[i]),
                        row.noise_mm_per_s[i], last_digit)
                << row.name << " " << row.encoder_step_m;
        }
        EXPECT_NEAR(1e3 * lag_s(row.make, 1e-3, row.encoder_step_m), row.lag_ms, 1.01)
            << row.name << " " << row.encoder_step_m;
    }
}

}  // namespace
}  // namespace touchline::stability
