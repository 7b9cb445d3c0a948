#include "haptics/guidance/guidance.h"
#include "tests/haptics/tick.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// What a hand could tell of a shake from its forces alone.
struct Measured {
    int pulses = 0;
    double angle_deg = 0.0;  // the line that it swings along, 0 ... 180
    double frequency_Hz = 0.0;
};

Measured measured(const std::vector<Force>& forces) {
    constexpr double quiet_N = 0.02;
    constexpr int quiet_ticks = 40;
    Measured result;
    double xx = 0.0, yy = 0.0, xy = 0.0;
    int quiet = quiet_ticks;
    int first = -1, last = -1, turns = 0;
    double pulse_s = 0.0;
    Force before;
    const auto end_pulse = [&] { pulse_s += tick_s * (last - first); };
    for (int i = 0; i < static_cast<int>(forces.size()); ++i) {
        const Force f = forces[static_cast<std::size_t>(i)];
        xx += f.x * f.x;
        yy += f.y * f.y;
        xy += f.x * f.y;
        if (norm(f) <= quiet_N) {
            ++quiet;
            continue;
        }
        if (quiet >= quiet_ticks) {
            if (first >= 0) end_pulse();
            ++result.pulses;
            first = i;
        } else if (dot(f, before) < 0.0) {
            ++turns;
        }
        quiet = 0;
        last = i;
        before = f;
    }
    if (first >= 0) end_pulse();
    const double axis = 0.5 * std::atan2(2.0 * xy, xx - yy) * 180.0 / 3.14159265358979;
    result.angle_deg = axis < -1.0 ? axis + 180.0 : axis;
    result.frequency_Hz = pulse_s > 0.0 ? 0.5 * turns / pulse_s : 0.0;
    return result;
}

/// Returns the forces as played, from a command to the end.
std::vector<Force> played(HandlePattern pattern) {
    PatternPlayer player;
    (void)player.step({HandlePattern::none, 0}, true, tick_s);
    std::vector<Force> forces;
    for (int i = 0; i < 2500; ++i) forces.push_back(player.step({pattern, 1}, true, tick_s));
    return forces;
}

TEST(HandlePatterns, EveryPatternHasOneRow) {
    ASSERT_EQ(pattern_rows().size(), handle_pattern_count - 1);
    for (std::size_t i = 0; i < pattern_rows().size(); ++i)
        EXPECT_EQ(static_cast<std::size_t>(pattern_rows()[i].pattern), i + 1);
}

TEST(HandlePatterns, AnyTwoDifferInTwoOfPulsesDirectionAndFrequency) {
    std::vector<Measured> all;
    for (const PatternRow& row : pattern_rows()) {
        all.push_back(measured(played(row.pattern)));
        EXPECT_EQ(all.back().pulses, row.pulses);
    }
    for (std::size_t a = 0; a < all.size(); ++a) {
        for (std::size_t b = a + 1; b < all.size(); ++b) {
            int differences = all[a].pulses != all[b].pulses ? 1 : 0;
            const double apart = std::abs(all[a].angle_deg - all[b].angle_deg);
            if (std::min(apart, 180.0 - apart) > 40.0) ++differences;
            const double ratio = all[a].frequency_Hz / all[b].frequency_Hz;
            if (std::max(ratio, 1.0 / ratio) > 1.4) ++differences;
            EXPECT_GE(differences, 2) << a << " and " << b;
        }
    }
}

TEST(HandlePatterns, AreWeakShortAndPushNowhere) {
    for (const PatternRow& row : pattern_rows()) {
        Force sum;  // integral of the force: what sets the handle going ...
        Force way;  // ... and how far it would coast
        double most_N = 0.0;
        for (const Force f : played(row.pattern)) {
            sum += tick_s * f;
            way += tick_s * sum;
            most_N = std::max(most_N, norm(f));
        }
        EXPECT_LE(most_N, 1.0);
        EXPECT_GT(most_N, 0.3);
        EXPECT_LT(norm(sum), 1e-4);
        EXPECT_LT(norm(way), 1e-4);
        EXPECT_LE(duration_s(row), 1.5);
    }
}

TEST(HandlePatterns, TheFirstNumberToldAndADeadHandlePlayNothing) {
    PatternPlayer player;
    double most_N = 0.0;
    for (int i = 0; i < 500; ++i)
        most_N = std::max(most_N, norm(player.step({HandlePattern::error, 7}, true, tick_s)));
    for (int i = 0; i < 500; ++i)
        most_N = std::max(most_N, norm(player.step({HandlePattern::error, 8}, false, tick_s)));
    for (int i = 0; i < 500; ++i)
        most_N = std::max(most_N, norm(player.step({HandlePattern::error, 8}, true, tick_s)));
    EXPECT_EQ(most_N, 0.0);
    EXPECT_EQ(player.serial(), 8U);
}

TEST(HandlePatterns, ANewOneTakesThePlaceOfWhatPlays) {
    PatternPlayer player;
    (void)player.step({}, true, tick_s);
    for (int i = 0; i < 60; ++i) (void)player.step({HandlePattern::edge, 1}, true, tick_s);
    std::vector<Force> after;
    for (int i = 0; i < 400; ++i)
        after.push_back(player.step({HandlePattern::focus, 2}, true, tick_s));
    double late_y_N = 0.0;
    double late_x_N = 0.0;
    for (std::size_t i = 22; i < after.size(); ++i) {
        late_y_N = std::max(late_y_N, std::abs(after[i].y));
        late_x_N = std::max(late_x_N, std::abs(after[i].x));
    }
    EXPECT_EQ(late_y_N, 0.0);  // the edge's force is over
    EXPECT_GT(late_x_N, 0.3);
}

}  // namespace
}  // namespace touchline
