// Any picture, of one pixel or of many, becomes a sound map or one clear line: 2000 of one seed;
// with TOUCHLINE_EXHAUSTIVE set, 200 000 of a hundred seeds.
#include "tests/vision/simplify/trace_task.h"

#include <cstdlib>
#include <iostream>

#include <gtest/gtest.h>

namespace touchline::testing {
namespace {

constexpr int kPictures = 2000;
constexpr int kSeeds = 100;

class RandomPictures : public ::testing::TestWithParam<int> {};

/// A tenth each, so that the parts run beside each other.
constexpr int kParts = 10;

int seeds() {
    // NOLINTNEXTLINE(concurrency-mt-unsafe)
    return std::getenv("TOUCHLINE_EXHAUSTIVE") != nullptr ? kSeeds : 1;
}

TEST_P(RandomPictures, AreASoundMapOrOneClearLine) {
    TraceTally tally;
    for (int seed = 0; seed < seeds(); ++seed) {
        for (int n = GetParam(); n < kPictures; n += kParts) {
            const std::vector<std::uint8_t> bytes =
                random_picture_bytes(static_cast<std::uint64_t>(seed), n, kTaskBytes);
            const TraceTask task = task_of(bytes);
            for (const std::string& fault : faults_of(task, tally)) {
                ADD_FAILURE() << "seed " << seed << ", number " << n << ", " << words_for(task)
                              << ": " << fault;
            }
        }
    }
    std::cout << tally.tasks << " pictures, " << tally.maps << " maps, " << tally.lines
              << " clear lines\n";
    EXPECT_GT(tally.maps, tally.tasks / 2);
    EXPECT_GT(tally.lines, 0);
}

INSTANTIATE_TEST_SUITE_P(Tenth, RandomPictures, ::testing::Range(0, kParts));

}  // namespace
}  // namespace touchline::testing
