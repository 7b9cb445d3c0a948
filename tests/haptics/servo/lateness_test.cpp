#include "haptics/servo/lateness.h"

#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace touchline
