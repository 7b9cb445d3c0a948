// Tests a tracer that lies: the kiosk gets a map or one line, and keeps nothing of the worker.
#include "app/documents/trace/tracing.h"
#include "tests/app/documents/decode/liar_in_place.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Puts the lie in the pixels.
Result<TracedMap> trace_lie(const std::string& lie) {
    Page page;
    page.picture = {20, 1, std::vector<std::uint8_t>(60), 1.0};
    const std::string text = "liar " + lie;
    std::ranges::copy(text, page.picture.bgr.begin());
    return trace_page(page, {});
}

TEST(TracingLiar, IsBelievedOnlyWhenItIsHonest) {
    const LiarInPlace liar(TOUCHLINE_LIARS);
    const auto traced = trace_lie("honest");
    ASSERT_TRUE(traced.has_value()) << traced.error().line;
    EXPECT_EQ(traced->map.outlines.at(0).label, "a line");
}

class TracingLies : public ::testing::TestWithParam<const char*> {};

TEST_P(TracingLies, EndInOneSentenceAndLeaveNothing) {
    const LiarInPlace liar(TOUCHLINE_LIARS);
    (void)trace_lie("honest");
    const int descriptors = open_descriptors();
    const long before_kB = resident_kB();
    const auto traced = trace_lie(GetParam());
    ASSERT_FALSE(traced.has_value());
    EXPECT_TRUE(is_one_sentence(traced.error().line)) << traced.error().line;
    EXPECT_EQ(open_descriptors(), descriptors);
    EXPECT_FALSE(has_a_child());
    EXPECT_LT(resident_kB() - before_kB, 1024);
}

INSTANTIATE_TEST_SUITE_P(All, TracingLies,
                         ::testing::Values("a page", "no lines", "empty map", "escapes",
                                           "wrong magic", "huge header", "short", "long",
                                           "second header", "header alone", "half a header",
                                           "noise", "hole", "nothing", "status", "abort", "crash",
                                           "fork", "connect", "fill", "eat", "spin", "sleep"));

}  // namespace
}  // namespace touchline
