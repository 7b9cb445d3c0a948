#include "tests/lab/stability/adversary.h"

#include "tests/lab/stability/limits.h"

#include <gtest/gtest.h>

namespace touchline::stability {
namespace {

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
