#include "haptics/servo/real_time.h"

#include "haptics/servo/servo.h"
#include "tests/haptics/servo/rigs.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include <grp.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr std::int64_t us = 1000;

TEST(LatenessHistogram, QuantilesAreThoseOfWhatWasAdded) {
    LatenessHistogram histogram;
    EXPECT_EQ(histogram.quantile_us(0.5), 0);
    for (int i = 1; i <= 1000; ++i) histogram.add(i * us);
    EXPECT_EQ(histogram.count(), 1000U);
    EXPECT_EQ(histogram.quantile_us(0.5), 500);
    EXPECT_EQ(histogram.quantile_us(0.99), 990);
    EXPECT_EQ(histogram.quantile_us(1.0), 1000);
    EXPECT_EQ(histogram.quantile_us(0.0), 1);
    EXPECT_EQ(histogram.count_below(1), 0U);
    EXPECT_EQ(histogram.count_below(101), 100U);
}

TEST(LatenessHistogram, EarlyIsInTimeAndVeryLateIsInTheLastBin) {
    LatenessHistogram histogram;
    histogram.add(-5 * us);
    EXPECT_EQ(histogram.quantile_us(1.0), 0);
    histogram.add(3'600'000'000'000);
    EXPECT_EQ(histogram.quantile_us(1.0), 10'000);
}

TEST(MinuteOfTicks, CountsLateTicksSkippedOnesAndLongGaps) {
    MinuteOfTicks minute;
    minute.add(0.0, 0.0, 0.0, 0);
    minute.add(0.001, 0.001, 0.001, 0);  // exactly 1 ms is in time
    EXPECT_EQ(minute.last_minute().late, 0U);
    minute.add(0.002, 0.0011, 0.001, 0);
    minute.add(0.008, 0.0, 0.006, 5);
    EXPECT_EQ(minute.last_minute().late, 6U);
    minute.add(0.018, 0.0, 0.010, 0);  // nor is 10 ms a long gap
    EXPECT_EQ(minute.last_minute().long_gaps, 0U);
    minute.add(0.029, 0.0, 0.0101, 0);
    EXPECT_EQ(minute.last_minute().long_gaps, 1U);
}

TEST(MinuteOfTicks, ForgetsWhatIsAMinuteOld) {
    MinuteOfTicks minute;
    for (int s = 0; s < 200; ++s) {
        minute.add(s, 0.002, 0.02, 0);
        EXPECT_EQ(minute.last_minute().late, static_cast<std::uint64_t>(std::min(s + 1, 60)));
        EXPECT_EQ(minute.last_minute().long_gaps, minute.last_minute().late);
    }
    minute.add(229.0, 0.0, 0.0, 0);
    EXPECT_EQ(minute.last_minute().late, 30U);
    minute.add(1e6, 0.0, 0.0, 0);
    EXPECT_EQ(minute.last_minute().late, 0U);
    EXPECT_EQ(minute.last_minute().long_gaps, 0U);
}

TEST(RealTimeTier, OfTheLastMinuteIsTheOneGrantedOrTooLate) {
    for (const RealTimeTier granted :
         {RealTimeTier::real_time, RealTimeTier::fifo, RealTimeTier::best_effort}) {
        EXPECT_EQ(judge(granted, {0, 0}, 1e-3), granted);
        EXPECT_EQ(judge(granted, {60, 0}, 1e-3), granted);  // 0.1 % of 60 000
        EXPECT_EQ(judge(granted, {61, 0}, 1e-3), RealTimeTier::too_late);
        EXPECT_EQ(judge(granted, {0, 1}, 1e-3), RealTimeTier::too_late);
        EXPECT_EQ(judge(granted, {120, 0}, 5e-4), granted);
        EXPECT_EQ(judge(granted, {121, 0}, 5e-4), RealTimeTier::too_late);
    }
}

TEST(RealTimeTier, NoTierAllowsMoreThanABetterOne) {
    EXPECT_EQ(limits_of(RealTimeTier::real_time).force_share, 1.0);
    EXPECT_EQ(limits_of(RealTimeTier::fifo).stiffness_share, 1.0);
    EXPECT_EQ(limits_of(RealTimeTier::best_effort).force_share, 0.5);
    EXPECT_EQ(limits_of(RealTimeTier::best_effort).stiffness_share, 0.5);
    EXPECT_GT(limits_of(RealTimeTier::best_effort).extra_damping_Ns_per_m, 0.0);
    EXPECT_EQ(limits_of(RealTimeTier::too_late).force_share, 0.0);
}

TEST(RealTimeTier, EachHasWordsThatBeginWithItsLetter) {
    char letter = 'A';
    for (const RealTimeTier tier : {RealTimeTier::real_time, RealTimeTier::fifo,
                                    RealTimeTier::best_effort, RealTimeTier::too_late}) {
        EXPECT_EQ(describe(tier).substr(0, 2), std::string(1, letter++) + ",");
    }
}

/// Becomes user nobody, if this process may, and gives up the right to real-time priority in any
/// case.
bool become_ordinary() {
    const rlimit none{0, 0};
    constexpr unsigned nobody = 65534;
    if (setrlimit(RLIMIT_RTPRIO, &none) != 0) return false;
    return geteuid() != 0 ||
           (setgroups(0, nullptr) == 0 && setresgid(nobody, nobody, nobody) == 0 &&
            setresuid(nobody, nobody, nobody) == 0);
}

/// Returns what `ask` says in a process of an ordinary user.
int told_by_an_ordinary_user(const std::function<int()>& ask) {
    const pid_t child = fork();
    if (child == 0) _exit(become_ordinary() ? ask() : 99);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(RealTimeTier, OfAnOrdinaryUserIsC) {
    EXPECT_EQ(told_by_an_ordinary_user(
                  [] { return static_cast<int>(become_real_time(MemoryLock::as_touched)); }),
              static_cast<int>(RealTimeTier::best_effort));
}

TEST(RealTimeTier, OfAServoWithMotorsThatAnOrdinaryUserStartsIsNoBetterThanC) {
    const int tier = told_by_an_ordinary_user([] {
        Servo servo;
        ServoOptions options;
        options.has_motors = true;
        const auto started = servo.start(std::make_unique<PlacedDevice>(Position{0.0, 0.01}),
                                         default_profile(), options);
        if (!started) return 98;
        while (servo.latest().ticks < 10) std::this_thread::yield();
        return static_cast<int>(servo.tier().value());
    });
    // Tier D if this machine has been too busy meanwhile.
    EXPECT_TRUE(tier == static_cast<int>(RealTimeTier::best_effort) ||
                tier == static_cast<int>(RealTimeTier::too_late))
        << tier;
}

}  // namespace
}  // namespace touchline
