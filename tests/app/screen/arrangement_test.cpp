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
    const Arrangement a = arrange(width, height, sizes, *rc::gen::arbitrary<bool>());
    RC_ASSERT(area_of(a.sheet) + area_of(a.captions) + area_of(a.picture) ==
              static_cast<double>(width) * height);
    for (const Rect& rect : {a.sheet, a.captions, a.picture}) RC_ASSERT(is_whole(rect));
    RC_ASSERT(a.captions.y + a.captions.height == height);
}

TEST(Arrangement, APictureStandsBesideOnAWideScreenAndAboveOnAnUprightOne) {
    const Arrangement wide = arrange(1920, 1080, TextSizes{}, true);
    EXPECT_EQ(wide.sheet.x, wide.picture.width);
    const Arrangement upright = arrange(1080, 1920, TextSizes{}, true);
    EXPECT_EQ(upright.sheet.y, upright.picture.height);
}

RC_GTEST_PROP(Arrangement, APictureIsOfUseOrNotThereAndLeavesTheSheetItsRoom, ()) {
    const int width = *rc::gen::inRange(480, 2000);
    const int height = *rc::gen::inRange(320, 2000);
    const auto size = static_cast<TextSize>(*rc::gen::inRange(0, 4));
    const TextSizes sizes = text_sizes(size, 27.0, width, height);
    const Arrangement a = arrange(width, height, sizes, true);
    RC_ASSERT(area_of(a.picture) == 0.0 || std::min(a.picture.width, a.picture.height) >= 160.0);
    RC_ASSERT(a.sheet.width >= std::min(12.0 * sizes.cap_px, 1.0 * width) - 1.0);
}

TEST(Arrangement, ALargeScreenGivesThePictureMostOfItself) {
    EXPECT_GT(arrange(1920, 1080, TextSizes{}, true).picture.width, 960.0);
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
    EXPECT_LT(small_px, 54.0);  // on a screen of 16 cm
    EXPECT_GT(small_px, 45.0);
}

TEST(TextSizes, NoLetterIsSmallerThanNormal) {
    for (const TextSize size :
         {TextSize::normal, TextSize::large, TextSize::larger, TextSize::largest}) {
        const TextSizes sizes = text_sizes(size, 27.0, 1280, 800);
        EXPECT_GE(sizes.mark_px, 27.0);
        EXPECT_GE(caption_rows(800, sizes).sign_px, 27.0);
    }
}

}  // namespace
}  // namespace touchline
