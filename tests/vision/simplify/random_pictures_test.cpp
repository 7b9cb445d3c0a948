// Any picture, of one pixel or of many, becomes a sound map or one clear line. Tries 2000 of one
// seed, or with TOUCHLINE_EXHAUSTIVE set 200 000 of a hundred seeds (under the sanitizers 50 000),
// and those that once failed.
#include "tests/vision/simplify/trace_task.h"

#include <array>
#include <cstdlib>
#include <iostream>

#include <gtest/gtest.h>

namespace touchline::testing {
namespace {

constexpr int pictures_per_seed = 2000;
#ifdef __SANITIZE_ADDRESS__
constexpr int exhaustive_seeds = 25;
#else
constexpr int exhaustive_seeds = 100;
#endif

class RandomPictures : public ::testing::TestWithParam<int> {};

/// Each part takes a tenth, so that the parts run in parallel.
constexpr int part_count = 10;

int seeds() {
    // NOLINTNEXTLINE(concurrency-mt-unsafe)
    return std::getenv("TOUCHLINE_EXHAUSTIVE") != nullptr ? exhaustive_seeds : 1;
}

struct Numbered {
    std::uint64_t seed;
    int number;
};

void judge(const Numbered& picture, TraceTally& tally) {
    const TraceTask task = task_of(random_picture_bytes(picture.seed, picture.number, task_bytes));
    for (const std::string& fault : faults_of(task, tally)) {
        ADD_FAILURE() << "seed " << picture.seed << ", number " << picture.number << ", "
                      << words_for(task) << ": " << fault;
    }
}

TEST_P(RandomPictures, AreASoundMapOrOneClearLine) {
    TraceTally tally;
    for (int seed = 0; seed < seeds(); ++seed) {
        for (int n = GetParam(); n < pictures_per_seed; n += part_count) {
            judge({static_cast<std::uint64_t>(seed), n}, tally);
        }
    }
    std::cout << tally.tasks << " pictures, " << tally.maps << " maps, " << tally.lines
              << " clear lines\n";
    EXPECT_GT(tally.maps, tally.tasks / 2);
    EXPECT_GT(tally.lines, 0);
}

TEST(RandomPictures, ThatOnceWereAtFaultAreNot) {
    constexpr std::array once_at_fault{
        Numbered{59, 1131},  // a line of 0.2 mm without strength, lighter than a map may hold
        Numbered{64, 1402},  // a foot on a ring that leads back along itself
        Numbered{97, 1323},  // the same
        Numbered{20, 1738},  // the same on an open line
        Numbered{24, 1065},  // made longer than the least length by another in its way
    };
    TraceTally tally;
    for (const Numbered& once : once_at_fault) {
        judge(once, tally);
    }
    EXPECT_GE(tally.maps, static_cast<int>(once_at_fault.size()));
}

INSTANTIATE_TEST_SUITE_P(Tenth, RandomPictures, ::testing::Range(0, part_count));

}  // namespace
}  // namespace touchline::testing
