// Tests every fault of a device and of a kiosk with the whole loop, on the virtual clock: time to
// zero torque, what is told and said, no force before it is armed again, the way back.
#include "app/visit/told_lines.h"
#include "tests/haptics/tick.h"
#include "tests/machines/sim/fault_lines.h"
#include "tests/machines/sim/loop/loop_fault_run.h"

#include <limits>
#include <map>
#include <ostream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace touchline {

/// Prints the kind for GoogleTest.
void PrintTo(const LoopFaultKind& kind, std::ostream* out) {
    *out << kind.name;
}

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// What must hold for every run of a kind of fault.
struct Demand {
    double zero_s;        // at most; inf: torque may go on
    Fault worst;          // none graver is told
    bool is_sure;         // every run tells it
    bool is_back_itself;  // if not: another servo, or the operator
};

const std::map<std::string_view, Demand> demands{
    {"short", {tick_s, Fault::none, true, true}},
    {"late send", {inf, Fault::none, true, true}},
    {"lost send", {inf, Fault::none, true, true}},
    {"unconfirmed send", {inf, Fault::none, true, true}},
    {"stall, out", {2.0 * tick_s, Fault::none, true, true}},
    {"late reply", {0.005, Fault::device_lost, false, true}},
    {"lost reply", {inf, Fault::none, true, true}},
    {"garbled", {inf, Fault::none, true, true}},
    {"wrong length", {tick_s, Fault::none, true, true}},
    {"duplicate", {tick_s, Fault::none, true, true}},
    {"zero-length packet", {inf, Fault::none, true, true}},
    {"stall, in", {2.0 * tick_s, Fault::none, true, true}},
    {"failed transfer", {tick_s, Fault::none, true, true}},
    {"unconfigured", {0.006, Fault::device_lost, false, true}},
    {"unplugged before", {tick_s, Fault::device_lost, true, false}},
    {"unplugged in mid-transfer", {tick_s, Fault::device_lost, true, false}},
    {"encoder jump", {tick_s, Fault::device_lost, true, false}},
    {"angle not a number", {tick_s, Fault::not_finite, true, false}},
    {"machine stands still", {inf, Fault::device_lost, false, true}},
    {"kiosk frozen", {0.020, Fault::none, true, false}},
    {"kiosk hangs 0.5 s", {0.020, Fault::none, true, true}},
    {"kiosk killed", {0.020, Fault::none, true, false}},
};

std::string words(const LoopFaultRun& run) {
    if (run.fault != Fault::none) return "fault: " + std::string(words_of(run.fault).why);
    return run.zero_s ? "no force for a while" : "force goes on";
}

class LoopFaults : public testing::TestWithParam<LoopFaultKind> {};

TEST_P(LoopFaults, EndInZeroTorqueAreSaidAndForceComesBackArmed) {
    const LoopFaultKind kind = GetParam();
    const Demand demand = demands.at(kind.name);
    (void)run_loop_fault(kind, 0);  // makes what all runs share
    for (std::uint64_t seed = 0; seed < fault_runs(10); ++seed) {
        SCOPED_TRACE(std::string(kind.name) + ", seed " + std::to_string(seed));
        const Holdings before = Holdings::now();
        const LoopFaultRun run = run_loop_fault(kind, seed);
        const Holdings left = Holdings::now() - before;
        tell({"servo", kind.name, seed, run.zero_s, words(run),
              run.zero_s ? run.back_s : std::nullopt, run.is_back_by_itself, left});
        EXPECT_EQ(left.descriptors, 0);
        EXPECT_EQ(left.bytes, 0);
        EXPECT_TRUE(run.was_pressed);
        EXPECT_LE(run.zero_s.value_or(0.0), demand.zero_s + 1e-9);
        EXPECT_LE(run.fault, demand.worst);
        EXPECT_TRUE(run.fault == demand.worst || !demand.is_sure) << words(run);
        EXPECT_EQ(spoken_fault(run.fault, Language()).empty(), run.fault == Fault::none);
        EXPECT_FALSE(run.was_pushed_before_arm);
        const bool may_stay_off = kind.event == LoopEvent::kiosk_freezes || !run.zero_s;
        EXPECT_TRUE(run.back_s.has_value() || may_stay_off);
        EXPECT_TRUE(!run.back_s || run.is_back_by_itself == demand.is_back_itself);
        EXPECT_TRUE(run.is_left_zero);
    }
}

INSTANTIATE_TEST_SUITE_P(Every, LoopFaults,
                         testing::ValuesIn(loop_fault_kinds().begin(), loop_fault_kinds().end()),
                         [](const auto& kind) { return test_name(kind.param.name); });

}  // namespace
}  // namespace touchline
