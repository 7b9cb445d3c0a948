#include "app/screen/layout.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

double area_of(const Rect& rect) {
    return rect.width * rect.height;
}

bool is_whole(const Rect& rect) {
    const auto whole = [](double value) { return value == static_cast<int>(value); };
    return whole(rect.x) && whole(rect.y) && whole(rect.width) && whole(rect.height);
}

RC_GTEST_PROP(Arrangement, CoversTheScreenWithoutGapOrOverlap, ()) {
    const int width = *rc::gen::inRange(480, 4000);
    const int height = *rc::gen::inRange(320, 4000);
    const auto size = static_cast<TextSize>(*rc::gen::inRange(0, 4));
    const TextSizes sizes = text_sizes(size, *rc::gen::inRange(12, 81), width, height);
    const Beside beside{*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
    const Arrangement a = arrange(width, height, sizes, beside);
    double covered = 0.0;
    for (const Rect& rect : {a.header, a.sheet, a.captions, a.picture, a.panel}) {
        RC_ASSERT(is_whole(rect));
        covered += area_of(rect);
    }
    RC_ASSERT(covered == static_cast<double>(width) * height);
    RC_ASSERT(a.captions.y + a.captions.height == height);
}

constexpr Beside with_picture{true, false};

TEST(Arrangement, APictureStandsBesideOnAWideScreenAndAboveOnAnUprightOne) {
    const Arrangement wide = arrange(1920, 1080, TextSizes{}, with_picture);
    EXPECT_EQ(wide.sheet.x, wide.picture.width);
    const Arrangement upright = arrange(1080, 1920, TextSizes{}, with_picture);
    EXPECT_EQ(upright.sheet.y, upright.picture.y + upright.picture.height);
}

TEST(Arrangement, TheLargestLettersHaveTheWholeWidthOfASmallScreen) {
    const TextSizes sizes = text_sizes(TextSize::largest, 27.0, 1280, 720);
    EXPECT_EQ(arrange(1280, 720, sizes, with_picture).sheet.width, 1280.0);
}

TEST(Arrangement, TheLiveViewLeavesMenuAndCaptionWhereTheyWere) {
    const Arrangement without = arrange(1280, 720, TextSizes{}, with_picture);
    const Arrangement with = arrange(1280, 720, TextSizes{}, {true, true});
    EXPECT_EQ(with.header, without.header);
    EXPECT_EQ(with.sheet, without.sheet);
    EXPECT_EQ(with.captions, without.captions);
    EXPECT_GE(with.picture.width, 160.0);
    EXPECT_GE(with.panel.width, 300.0);
}

RC_GTEST_PROP(Arrangement, APictureIsOfUseOrNotThereAndLeavesTheSheetItsRoom, ()) {
    const int width = *rc::gen::inRange(480, 2000);
    const int height = *rc::gen::inRange(320, 2000);
    const auto size = static_cast<TextSize>(*rc::gen::inRange(0, 4));
    const TextSizes sizes = text_sizes(size, 27.0, width, height);
    const Arrangement a = arrange(width, height, sizes, with_picture);
    RC_ASSERT(area_of(a.picture) == 0.0 || std::min(a.picture.width, a.picture.height) >= 160.0);
    RC_ASSERT(a.sheet.width >= std::min(12.0 * sizes.cap_px, 1.0 * width) - 1.0);
}

TEST(Arrangement, ALargeScreenGivesThePictureMostOfItself) {
    EXPECT_GT(arrange(1920, 1080, TextSizes{}, with_picture).picture.width, 960.0);
}

TEST(TextSizes, AreThoseOfTheirAngles) {
    constexpr double mm_per_px = 0.25;
    const double normal_px = cap_height_px(0.6, mm_per_px);
    const auto mm = [&](TextSize size) {
        return mm_per_px * text_sizes(size, normal_px, 1920, 1080).cap_px;
    };
    EXPECT_NEAR(mm(TextSize::normal), 7.33, 0.01);  // 2 d tan(angle / 2)
    EXPECT_NEAR(mm(TextSize::large), 10.47, 0.01);
    EXPECT_NEAR(mm(TextSize::larger), 14.66, 0.01);
    EXPECT_NEAR(mm(TextSize::largest), 20.95, 0.03);
}

TEST(TextSizes, TheLargestHasItsSizeFromEightHundredLinesOn) {
    EXPECT_NEAR(text_sizes(TextSize::largest, 27.0, 1280, 800).cap_px, 77.1, 0.1);
    const double small_px = text_sizes(TextSize::largest, 27.0, 800, 600).cap_px;
    EXPECT_LT(small_px, 58.0);  // on a screen of 16 cm
    EXPECT_GT(small_px, 45.0);
}

}  // namespace
}  // namespace touchline
