// Traces a few pictures of the gallery by feel, and shows that nobody can without force.
#include "app/documents/gallery/gallery.h"
#include "tests/lab/bench/tracing/gallery_trial.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace touchline::bench {
namespace {

const Gallery& gallery() {
    static const Gallery read = read_trials(gallery_folder()).value();
    return read;
}

class SimulatedTracing : public testing::TestWithParam<const char*> {
  protected:
    [[nodiscard]] static std::size_t picture() {
        const auto& trials = gallery().trials;
        const auto found = std::find_if(trials.begin(), trials.end(), [](const Trial& trial) {
            return trial.name.find(GetParam()) != std::string::npos;
        });
        return static_cast<std::size_t>(found - trials.begin());
    }
};

TEST_P(SimulatedTracing, ByForceAloneThePictureIsTracedAndNamed) {
    const TrialResult result = attempt(gallery(), picture(), Tracing::groove);
    EXPECT_LE(result.score.p90_m, most_p90_m);
    EXPECT_GE(result.score.covered, least_covered);
    EXPECT_TRUE(result.is_named);
    EXPECT_LE(result.traced.time_s, gallery().trials[picture()].limit_s);
}

TEST_P(SimulatedTracing, WithForcesOffItFails) {
    const TrialResult result = attempt(gallery(), picture(), Tracing::forces_off);
    EXPECT_FALSE(result.is_traced);
    EXPECT_FALSE(result.is_named);
    EXPECT_GT(result.traced.way.size(), 500U);  // it did look
}

TEST_P(SimulatedTracing, ATourLeadsARelaxedHandAllAlong) {
    const TrialResult result = attempt(gallery(), picture(), Tracing::tour);
    EXPECT_TRUE(result.is_traced);
    EXPECT_TRUE(result.is_named);
    EXPECT_LE(result.traced.most_N, 1.3);  // 1 N plus what a weak groove adds
}

INSTANTIATE_TEST_SUITE_P(Gallery, SimulatedTracing,
                         testing::Values("star", "letter-a", "fish", "circle", "maze"));

}  // namespace
}  // namespace touchline::bench
