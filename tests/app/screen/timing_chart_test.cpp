#include "app/screen/staff_panel.h"
#include "tests/app/screen/probes.h"
#include "tests/app/screen/sample_screens.h"

#include <memory>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(LatenessBars, HoldEveryTickOnce) {
    const auto lateness = std::make_unique<LatenessHistogram>();
    for (const std::int64_t late_us : {0, 19, 20, 49, 60, 150, 999, 1000, 50'000})
        lateness->add(1000 * late_us);
    EXPECT_EQ(bars_of(*lateness).ticks,
              (std::array<std::uint64_t, LatenessBars::count>{2, 2, 1, 1, 1, 2}));
}

/// Counts the pixels of a row in the colour of bars.
int bar_px(const Canvas& canvas, double y_px) {
    int length = 0;
    for (int x = 0; x < canvas.width(); ++x)
        length += is_near(colour_at(canvas, {x + 0.5, y_px}), white_on_black.outline);
    return length;
}

TEST(TimingChart, HasABarForASingleTickAmongMillionsAndNoneForNone) {
    constexpr double cap_px = 20.0;
    const Canvas canvas(600, 400);
    LatenessBars bars;
    bars.ticks = {5'000'000, 1000, 1, 0, 0, 0};
    paint_timing(canvas.context(), {10.0, 10.0, 580.0, 380.0}, bars, cap_px, white_on_black, {});
    const double row_px = timing_chart_height_px(cap_px) / (LatenessBars::count + 1);
    const auto length = [&](int bar) { return bar_px(canvas, 10.0 + (bar + 1.5) * row_px); };
    EXPECT_EQ(length(1), 2);
    EXPECT_EQ(length(2), 2);
    EXPECT_EQ(length(3), 0);
}

TEST(TimingChart, ItsBarsAreToScale) {
    constexpr double cap_px = 20.0;
    const Canvas canvas(600, 400);
    LatenessBars bars;
    bars.ticks = {4000, 2000, 1000, 0, 0, 0};
    paint_timing(canvas.context(), {10.0, 10.0, 580.0, 380.0}, bars, cap_px, white_on_black, {});
    const double row_px = timing_chart_height_px(cap_px) / (LatenessBars::count + 1);
    const auto length = [&](int bar) { return bar_px(canvas, 10.0 + (bar + 1.5) * row_px); };
    EXPECT_NEAR(length(1), length(0) / 2.0, 2.0);
    EXPECT_NEAR(length(2), length(0) / 4.0, 2.0);
}

TEST(TimingChart, IsNotCutOffInAnyLanguage) {
    LatenessBars bars;
    bars.ticks = {123'456'789, 1000, 1, 0, 0, 987'654};
    for (const Language& language : every_language()) {
        const Canvas canvas(614, 400);
        paint_timing(canvas.context(), {10.0, 10.0, 594.0, 380.0}, bars, 27.0, white_on_black,
                     language);
        const Rect ink = ink_of(canvas);
        EXPECT_GE(ink.x, 9.0);
        EXPECT_LE(ink.x + ink.width, 605.0);
        EXPECT_LE(ink.y + ink.height, 10.0 + timing_chart_height_px(27.0));
    }
}

}  // namespace
}  // namespace touchline
