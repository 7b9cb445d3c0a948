#include "app/screen/theme.h"

#include <algorithm>
#include <array>
#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr std::array palettes{PaletteName::white_on_black, PaletteName::black_on_white,
                              PaletteName::yellow_on_black, PaletteName::low_glare_grey};

double least_text_contrast(const Palette& palette) {
    double least = 21.0;
    for (const Colour text : {palette.text, palette.name, palette.alert})
        least = std::min(least, contrast(text, palette.background));
    return least;
}

/// Returns how a pixel of a picture looks, dimmed over the background.
Colour dimmed(double grey, const Palette& palette) {
    const auto over = [&](double ground) {
        return palette.picture_alpha * grey + (1.0 - palette.picture_alpha) * ground;
    };
    const Colour& ground = palette.background;
    return {over(ground.red), over(ground.green), over(ground.blue)};
}

TEST(Palette, TextHasSevenToOneInEachAndTenToOneInTheDefault) {
    for (const PaletteName name : palettes)
        EXPECT_GE(least_text_contrast(palette_of(name)), 7.0) << static_cast<int>(name);
    EXPECT_GE(least_text_contrast(palette_of(PaletteName{})), 10.0);
}

TEST(Palette, BlackAndWhiteAreTheHighContrastOfTwentyToOne) {
    for (const PaletteName name : {PaletteName::white_on_black, PaletteName::black_on_white})
        EXPECT_GE(contrast(palette_of(name).text, palette_of(name).background), 20.0);
}

TEST(Palette, LowGlareHasNeitherBrightNorBlackGround) {
    const Palette& palette = palette_of(PaletteName::low_glare_grey);
    EXPECT_LT(palette.text.red, 0.9);
    EXPECT_GT(palette.background.red, 0.1);
}

TEST(Palette, FocusAndMarksStandOutFromTheGroundAndFromEveryPicture) {
    for (const PaletteName name : palettes) {
        const Palette& palette = palette_of(name);
        EXPECT_GE(contrast(palette.focus, palette.background), 3.0);
        for (const Colour mark :
             {palette.outline, palette.box, palette.handle, palette.proxy, palette.force}) {
            for (const double grey : {0.0, 0.5, 1.0})
                EXPECT_GE(contrast(mark, dimmed(grey, palette)), 3.0)
                    << static_cast<int>(name) << ' ' << grey << ' ' << mark.red;
        }
    }
}

TEST(Contrast, OfBlackAndWhiteIsTwentyOne) {
    EXPECT_NEAR(contrast({0, 0, 0}, {1, 1, 1}), 21.0, 1e-9);
    EXPECT_NEAR(contrast({1, 1, 1}, {1, 1, 1}), 1.0, 1e-12);
}

TEST(CapHeight, SubtendsSevenTenthsOfADegree) {
    EXPECT_NEAR(cap_height_px(0.6, 0.25) * 0.25, 7.33, 0.01);  // mm; EN 301 549 gives 7.3 at 0.6 m
}

TEST(CapHeight, AScreenThatLiesAboutItsSizeStaysReadable) {
    EXPECT_EQ(cap_height_px(0.6, 0.0), 27.0);
    EXPECT_EQ(cap_height_px(0.6, std::numeric_limits<double>::quiet_NaN()), 27.0);
    EXPECT_EQ(cap_height_px(0.6, 100.0), 12.0);
    EXPECT_EQ(cap_height_px(0.6, 0.001), 80.0);
}

}  // namespace
}  // namespace touchline
