// The peer workload (tests/lab/bench/workload.h), level 0, wall mode, point proxy: it lets nothing
// through, the proxy is as near to the hand as the curve allows, and it never slips off.
#include "tests/lab/bench/workload.h"

#include "haptics/contact/contact_machine.h"
#include "tests/haptics/contact/judge.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

struct Work {
    workload::Kind kind;
    std::size_t edges;
};

class PeerWorkload : public testing::TestWithParam<Work> {};

struct Outcome {
    int crossings = 0;
    int slip_offs = 0;
    int carried = 0;
    int grown = 0;
    double worst_force_error_N = 0.0;
    double worst_gain_m = 0.0;
    double least_distance_m = 1.0;
};

constexpr double slip_m =
    0.010;  // a gap that a desk-top pantograph cannot hold: the hand counts as slipped
constexpr int gain_every = 97;  // the search for a nearer place is slow

Outcome run(const Work& work, std::size_t steps) {
    const auto hand = workload::hand(work.kind, steps);
    const Scene scene =
        build_scene(workload::map_of(workload::curve(work.kind, work.edges)), {}, 0.0).value();
    const Judge judge(scene.curves, 0.0, 2e-4);
    ContactSettings settings;
    std::vector<Position> path;
    ContactMachine machine;
    machine.record_path(&path);
    machine.reset(scene, hand[0], 0.0);
    Outcome outcome;
    Position before = machine.proxy().centre;
    for (std::size_t i = 0; i < hand.size(); ++i) {
        const double gap_before = norm(hand[i] - before);
        const ContactReport report = machine.step(hand[i], 0.0, settings, {});
        outcome.crossings += judge.is_free(path) ? 0 : 1;
        outcome.grown += norm(hand[i] - report.p_WP) > gap_before + 1e-12 ? 1 : 0;
        const Force error = report.force - along<Force>(report.p_WP - hand[i], 500.0);
        outcome.worst_force_error_N = std::max(outcome.worst_force_error_N, norm(error));
        outcome.carried += report.carried_m > 0.0 ? 1 : 0;
        if (i % gain_every == 0 && report.carried_m == 0.0) {
            outcome.worst_gain_m =
                std::max(outcome.worst_gain_m, judge.possible_gain_m(report.p_WP, hand[i]));
        }
        before = report.p_WP;
        if (norm(report.p_WP - hand[i]) > slip_m) {
            ++outcome.slip_offs;
            machine.reset(scene, hand[i], 0.0);
            before = machine.proxy().centre;
        }
    }
    return outcome;
}

TEST_P(PeerWorkload, NothingIsLetThroughAndTheProxyIsAsNearAsItCanBe) {
    const Outcome outcome = run(GetParam(), 100000);
    RecordProperty("carried", outcome.carried);
    RecordProperty("slip_offs", outcome.slip_offs);
    std::printf(
        "  crossings %d, slip-offs %d, carried %d, grown %d, force error %.2e N, gain %.2e m\n",
        outcome.crossings, outcome.slip_offs, outcome.carried, outcome.grown,
        outcome.worst_force_error_N, outcome.worst_gain_m);
    EXPECT_EQ(outcome.crossings, 0);
    EXPECT_EQ(outcome.grown, 0);
    EXPECT_LE(outcome.worst_force_error_N, 1e-9);
    EXPECT_LE(outcome.worst_gain_m, 1e-9);
    if (GetParam().kind == workload::Kind::radial) {
        EXPECT_EQ(outcome.slip_offs, 0);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Curves, PeerWorkload,
    testing::Values(Work{workload::Kind::radial, 512}, Work{workload::Kind::radial, 4096},
                    Work{workload::Kind::radial, 65536}, Work{workload::Kind::fractal, 512},
                    Work{workload::Kind::fractal, 4096}, Work{workload::Kind::fractal, 65536}),
    [](const auto& test) {
        return (test.param.kind == workload::Kind::radial ? "radial" : "fractal") +
               std::to_string(test.param.edges);
    });

}  // namespace
}  // namespace touchline
