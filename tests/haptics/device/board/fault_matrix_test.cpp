// Every kind of fault at a hundred moments: time to zero torque, state, recovery. All runs use the
// virtual clock; tests/machines/sim/README.md has the figures.
#include "tests/haptics/tick.h"
#include "tests/machines/sim/board/fault_run.h"
#include "tests/machines/sim/fault_lines.h"

#include <map>
#include <ostream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace touchline {

/// Prints a kind in GoogleTest's messages.
void PrintTo(const FaultKind& kind, std::ostream* out) {
    *out << kind.name;
}

namespace {

constexpr double inf = never_s;

/// What must hold for every run of a kind.
struct Demand {
    double zero_s;                      // at most, from the moment when the fault could be seen
    double recovery_s;                  // at most; inf: does not recover by itself
    BoardState worst;                   // no worse than this
    std::uint64_t least_noticed = 100;  // of a hundred runs
};

// Bad data: zero within a tick. Late data: zero within the 5 ms for which stale data may be used. A
// send that hangs is cancelled at the second tick and made up for by the next, without a resync. A
// halted endpoint is cleared within a tick.
const std::map<std::string_view, Demand> demands{
    {"short", {tick_s, 0.02, BoardState::resyncing}},
    {"late send", {inf, 0.0, BoardState::ready, 0}},
    {"lost send", {inf, 0.0, BoardState::ready, 0}},
    {"unconfirmed send", {inf, 0.0, BoardState::ready, 0}},
    {"stall, out", {2.0 * tick_s, 0.02, BoardState::resyncing}},
    {"late reply", {0.005, 0.05, BoardState::resyncing, 60}},
    {"lost reply", {inf, 0.0, BoardState::ready, 0}},
    {"garbled", {tick_s, 0.02, BoardState::resyncing, 90}},
    {"wrong length", {tick_s, 0.02, BoardState::resyncing}},
    {"duplicate", {tick_s, 0.02, BoardState::resyncing}},
    {"zero-length packet", {inf, 0.0, BoardState::ready, 0}},
    {"stall, in", {2.0 * tick_s, 0.02, BoardState::resyncing}},
    {"failed transfer", {tick_s, 0.02, BoardState::resyncing}},
    {"unconfigured", {0.006, 0.1, BoardState::resyncing}},
    {"unplugged before", {tick_s, inf, BoardState::lost}},
    {"unplugged in mid-transfer", {tick_s, inf, BoardState::lost}},
    {"encoder jump", {tick_s, inf, BoardState::jumped}},
    {"torque not a number", {tick_s, 0.0, BoardState::ready, 0}},
    {"clock back 10 s", {inf, 0.0, BoardState::ready, 0}},
    {"clock on 10 s", {inf, 0.0, BoardState::ready, 0}},
    {"loop stands still 50 ms", {inf, 0.0, BoardState::ready, 0}},
};

void tell(const FaultKind& kind, std::uint64_t seed, const FaultRun& run, const Holdings& left) {
    FaultLine line{"driver", kind.name, seed, {}, words_of(run), {}, run.has_recovered, left};
    if (run.was_noticed || run.zero_s < 1.0) line.zero_s = run.zero_s;
    if (run.has_recovered && line.zero_s) line.back_s = run.recovery_s;
    if (run.has_reopened) line.back_s = run.reopened_s;
    tell(line);
}

class FaultMatrix : public testing::TestWithParam<FaultKind> {};

TEST_P(FaultMatrix, EndsInZeroTorqueAndFindsBack) {
    const FaultKind kind = GetParam();
    const Demand demand = demands.at(kind.name);
    const std::uint64_t runs = fault_runs(100, 300);
    std::uint64_t noticed = 0;
    (void)run_fault(kind, 0);  // makes what all runs share
    for (std::uint64_t seed = 0; seed < runs; ++seed) {
        const Holdings before = Holdings::now();
        const FaultRun run = run_fault(kind, seed);
        const Holdings left = Holdings::now() - before;
        tell(kind, seed, run, left);
        SCOPED_TRACE(std::string(kind.name) + ", seed " + std::to_string(seed));
        noticed += run.was_noticed ? 1 : 0;
        EXPECT_EQ(left.descriptors, 0);
        EXPECT_EQ(left.bytes, 0);
        EXPECT_FALSE(run.is_broken);
        EXPECT_TRUE(run.is_left_zero);
        EXPECT_LE(run.worst, demand.worst);
        const bool is_unnoticed_garble = kind.link == LinkFault::garbled_reply && !run.was_noticed;
        if (run.was_noticed || kind.is_torque_not_finite) {
            EXPECT_LE(run.zero_s, demand.zero_s + 1e-9);
        }
        if (demand.recovery_s < inf) {
            EXPECT_TRUE(run.has_recovered);
            EXPECT_LE(run.recovery_s, demand.recovery_s + 1e-9);
        }
        if (demand.worst == BoardState::lost) {
            EXPECT_TRUE(run.has_reopened);
        }
        if (!is_unnoticed_garble) {
            EXPECT_LE(run.largest_error_counts, 2.0);
        }
    }
    EXPECT_GE(100 * noticed, demand.least_noticed * runs);
}

INSTANTIATE_TEST_SUITE_P(Every, FaultMatrix,
                         testing::ValuesIn(fault_kinds().begin(), fault_kinds().end()),
                         [](const auto& kind) { return test_name(kind.param.name); });

TEST(FaultMatrixItself, SameSeedsGiveTheSameRuns) {
    for (const FaultKind& kind : fault_kinds()) {
        const FaultRun a = run_fault(kind, 3);
        const FaultRun b = run_fault(kind, 3);
        EXPECT_EQ(a.zero_s, b.zero_s);
        EXPECT_EQ(a.recovery_s, b.recovery_s);
        EXPECT_EQ(a.largest_error_counts, b.largest_error_counts);
    }
}

}  // namespace
}  // namespace touchline
