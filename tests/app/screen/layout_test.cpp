#include "app/screen/layout.h"

#include <array>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

TEST(Layout, AWideScreenHasThePanelOnTheRight) {
    const ScreenLayout layout = lay_out(1920, 1080);
    EXPECT_EQ(layout.picture, (Rect{0.0, 0.0, 1306.0, 1080.0}));
    EXPECT_EQ(layout.panel, (Rect{1306.0, 0.0, 614.0, 1080.0}));
}

TEST(Layout, AnyOtherScreenHasThePanelBelow) {
    for (const auto [width, height] : {std::array{1280, 1024}, {1024, 768}, {1080, 1920}}) {
        const ScreenLayout layout = lay_out(width, height);
        EXPECT_EQ(layout.panel.x, 0.0);
        EXPECT_EQ(layout.panel.y, layout.picture.height);
        EXPECT_EQ(layout.panel.y + layout.panel.height, height);
    }
}

RC_GTEST_PROP(Layout, TheWholeDrawingAreaLiesInThePicturePart, ()) {
    const ScreenLayout layout = lay_out(*rc::gen::inRange(64, 4000), *rc::gen::inRange(64, 4000));
    const Area area{*rc::gen::inRange(20, 400) * 1e-3, *rc::gen::inRange(20, 400) * 1e-3};
    const Rect rect = area_rect(area, view_of(area, layout.picture));
    RC_ASSERT(rect.x >= layout.picture.x);
    RC_ASSERT(rect.y >= layout.picture.y);
    RC_ASSERT(rect.x + rect.width <= layout.picture.x + layout.picture.width);
    RC_ASSERT(rect.y + rect.height <= layout.picture.y + layout.picture.height);
}

TEST(View, UpInThePictureFrameIsUpOnTheScreen) {
    const View view = view_of(Area{}, {0.0, 0.0, 1160.0, 840.0});
    const PixelPoint centre = view.to_px({0.0, 0.0});
    EXPECT_EQ(centre, (PixelPoint{580.0, 420.0}));
    EXPECT_LT(view.to_px({0.0, 0.01}).y, centre.y);
    EXPECT_GT(view.to_px({0.01, 0.0}).x, centre.x);
}

TEST(View, ThePointerFindsTheSamePlaceAgain) {
    const View view = view_of(Area{}, {100.0, 50.0, 800.0, 600.0});
    const Position p{0.031, -0.022};
    EXPECT_NEAR(norm(view.to_W(view.to_px(p)) - p), 0.0, 1e-15);
}

TEST(Fitted, APictureKeepsItsShapeAndTouchesTwoSides) {
    const Area upright = fitted(Area{0.116, 0.084}, 300.0, 600.0);
    EXPECT_DOUBLE_EQ(upright.height_m, 0.084);
    EXPECT_DOUBLE_EQ(upright.width_m, 0.042);
}

}  // namespace
}  // namespace touchline
