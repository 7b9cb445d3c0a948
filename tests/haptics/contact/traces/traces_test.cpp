// The machine still does what it did when the traces were written.
#include "tests/haptics/contact/traces/trace.h"

#include <cstdlib>

#include <gtest/gtest.h>

namespace touchline::traces {
namespace {

/// Describes the first difference; empty if there is none.
std::string difference(const Row& wanted, const Row& found) {
    for (std::size_t i = 0; i < column_count; ++i) {
        if (std::abs(wanted[i] - found[i]) <= columns[i].tolerance) continue;
        return std::string(columns[i].name) + " is " + std::to_string(found[i]) + ", was " +
               std::to_string(wanted[i]);
    }
    return {};
}

class ReferenceTrace : public testing::TestWithParam<Trace> {};

TEST_P(ReferenceTrace, IsFollowedAgain) {
    const Trace& trace = GetParam();
    const Scene scene = scene_of(read_lines(trace.lines), trace);
    const std::vector<Row> wanted = read_rows(trace.name);
    const std::vector<Row> found = follow(scene, trace, wanted);
    for (std::size_t tick = 0; tick < wanted.size(); ++tick) {
        ASSERT_EQ(difference(wanted[tick], found[tick]), "") << "tick " << tick;
    }
}

INSTANTIATE_TEST_SUITE_P(All, ReferenceTrace, testing::ValuesIn(read_traces()),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace touchline::traces
