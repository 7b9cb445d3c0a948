#include "haptics/servo/real_time.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

constexpr std::int64_t ms = 1'000'000;

TEST(TickSchedule, IsAnEvenGrid) {
    TickSchedule schedule(5 * ms, ms);
    for (int k = 0; k < 1000; ++k) {
        EXPECT_EQ(schedule.due_ns(), (5 + k) * ms);
        EXPECT_NEAR(schedule.due_s(), k * 1e-3, 1e-15);
        schedule.finish(schedule.due_ns() + ms / 5);
    }
    EXPECT_EQ(schedule.missed(), 0U);
}

TEST(TickSchedule, LateTickStillRunsWithinItsOwnPeriod) {
    TickSchedule schedule(0, ms);
    schedule.finish(2 * ms - 1);  // the next, due at 1 ms, may still begin
    EXPECT_EQ(schedule.due_ns(), ms);
    EXPECT_EQ(schedule.missed(), 0U);
}

TEST(TickSchedule, OverrunSkipsAndCounts) {
    TickSchedule schedule(0, ms);
    schedule.finish(2 * ms);  // the tick due at 1 ms is over
    EXPECT_EQ(schedule.due_ns(), 2 * ms);
    EXPECT_EQ(schedule.missed(), 1U);
    schedule.finish(10'002 * ms + 7);  // a stall of ten seconds causes no burst
    EXPECT_EQ(schedule.due_ns(), 10'002 * ms);
    EXPECT_EQ(schedule.missed(), 10'000U);
}

RC_GTEST_PROP(TickSchedule, EveryTickIsRunOrMissedAndNoneIsOlderThanItsPeriod, ()) {
    TickSchedule schedule(0, ms);
    std::int64_t now_ns = 0;
    std::int64_t run = 0;
    for (int i = 0; i < 50; ++i) {
        now_ns = std::max(now_ns, schedule.due_ns());
        RC_ASSERT(now_ns - schedule.due_ns() < ms);
        ++run;
        now_ns += *rc::gen::inRange<std::int64_t>(0, 5 * ms);
        schedule.finish(now_ns);
        RC_ASSERT(schedule.due_ns() == (run + static_cast<std::int64_t>(schedule.missed())) * ms);
    }
}

TEST(MonotonicClock, NeverWakesEarly) {
    MonotonicClock clock;
    const std::int64_t until = clock.now_ns() + 100'000;
    clock.sleep_until(until);
    EXPECT_GE(clock.now_ns(), until);
    clock.sleep_until(0);  // long past: returns at once
}

}  // namespace
}  // namespace touchline
