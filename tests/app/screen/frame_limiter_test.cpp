#include "app/screen/pace.h"
#include "tests/app/screen/probes.h"

#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

constexpr std::int64_t start_ns = 123'456'789;

/// Runs frames that take `work_ns` each until `end_ns` of a virtual clock.
FrameLimiter run(std::int64_t work_ns, std::int64_t end_ns) {
    FrameLimiter limiter(start_ns, 60);
    for (std::int64_t now = start_ns; now < end_ns;) now = limiter.finish_frame(now + work_ns);
    return limiter;
}

TEST(FrameLimiter, GivesExactlySixtyFramesASecond) {
    const FrameLimiter limiter = run(3'000'000, start_ns + 10 * one_second_ns);
    EXPECT_EQ(limiter.frames(), 600);
    EXPECT_EQ(limiter.skipped(), 0);
}

TEST(FrameLimiter, NoRoundingAddsUpInADay) {
    FrameLimiter limiter(start_ns, 60);
    const std::int64_t day_ns = 86'400 * one_second_ns;
    EXPECT_EQ(limiter.finish_frame(start_ns + day_ns - 1), start_ns + day_ns);
}

TEST(FrameLimiter, AFrameThatTakesNoTimeIsStillFollowedByAWait) {
    FrameLimiter limiter(start_ns, 60);
    EXPECT_EQ(limiter.finish_frame(start_ns), start_ns + one_second_ns / 60);
}

TEST(FrameLimiter, SlowFramesSkipWholePeriodsWithoutABurst) {
    const FrameLimiter limiter = run(20'000'000, start_ns + 10 * one_second_ns);  // 1.2 periods
    EXPECT_EQ(limiter.frames(), 300);
    EXPECT_EQ(limiter.skipped(), 300);
}

TEST(FrameLimiter, AfterAPauseTheGridGoesOn) {
    FrameLimiter limiter(start_ns, 60);
    const std::int64_t due = limiter.finish_frame(start_ns + 5 * one_second_ns + 1);
    EXPECT_EQ(due, start_ns + 5 * one_second_ns + one_second_ns / 60);
    EXPECT_EQ(limiter.skipped(), 300);
}

RC_GTEST_PROP(FrameLimiter, IsAlwaysDueLaterThanNowAndAtMostAPeriodAhead, ()) {
    const int rate_Hz = *rc::gen::inRange(1, 1001);
    FrameLimiter limiter(start_ns, rate_Hz);
    std::int64_t now = start_ns;
    std::int64_t last_due = start_ns;
    for (const auto work : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 50'000'000))) {
        now += work;
        const std::int64_t due = limiter.finish_frame(now);
        RC_ASSERT(due > now);
        RC_ASSERT(due > last_due);
        RC_ASSERT(due - now <= one_second_ns / rate_Hz + 1);
        last_due = now = due;
    }
}

}  // namespace
}  // namespace touchline
