#include "app/screen/layout.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

RC_GTEST_PROP(View, TheWholeDrawingAreaLiesInItsPart, ()) {
    const Rect part{10.0, 20.0, 1.0 * *rc::gen::inRange(64, 4000),
                    1.0 * *rc::gen::inRange(64, 4000)};
    const Area area{*rc::gen::inRange(20, 400) * 1e-3, *rc::gen::inRange(20, 400) * 1e-3};
    const Rect rect = area_rect(area, view_of(area, part));
    RC_ASSERT(rect.x >= part.x);
    RC_ASSERT(rect.y >= part.y);
    RC_ASSERT(rect.x + rect.width <= part.x + part.width);
    RC_ASSERT(rect.y + rect.height <= part.y + part.height);
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
