#include "app/screen/paint.h"

#include "tests/app/screen/probes.h"

#include <array>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr int area_width = 1160;
constexpr int area_height = 840;
const View view{10'000.0,
                {area_width / 2.0, area_height / 2.0}};  // 0.1 mm a pixel, the default area

Canvas blank() {
    return {area_width, area_height};
}

Outline circle(double radius_m) {
    Outline outline;
    outline.is_closed = true;
    for (int i = 0; i < 256; ++i) {
        const double angle_rad = 2.0 * std::numbers::pi * i / 256;
        outline.points.push_back({radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad)});
    }
    return outline;
}

CurveSet curves_of(std::vector<Outline> outlines) {
    TactileMap map;
    map.outlines = std::move(outlines);
    auto curves = CurveSet::build(map, CurveOptions{});
    EXPECT_TRUE(curves.has_value());
    return std::move(*curves);
}

TEST(PaintOutlines, AClosedCurveIsDrawnWhereItIsAndNowhereElse) {
    const Canvas canvas = blank();
    paint_outlines(canvas.context(), view, curves_of({circle(0.03)}), 0.0, 4.0,
                   {white_on_black.outline});
    for (int i = 0; i < 64; ++i) {
        const double angle_rad = 2.0 * std::numbers::pi * (i + 0.3) / 64;
        const Position on{0.03 * std::cos(angle_rad), 0.03 * std::sin(angle_rad)};
        EXPECT_TRUE(is_near(colour_at(canvas, view.to_px(on)), white_on_black.outline)) << i;
        EXPECT_TRUE(is_black(colour_at(canvas, view.to_px(0.95 * on)))) << i;
        EXPECT_TRUE(is_black(colour_at(canvas, view.to_px(1.05 * on)))) << i;
    }
}

TEST(PaintOutlines, AnOpenCurveKeepsItsGap) {
    Outline corner;
    corner.points = {{-0.02, 0.0}, {0.02, 0.0}, {0.02, 0.02}};
    const Canvas canvas = blank();
    paint_outlines(canvas.context(), view, curves_of({corner}), 0.0, 4.0, {white_on_black.outline});
    EXPECT_TRUE(is_near(colour_at(canvas, view.to_px({0.0, 0.0})), white_on_black.outline));
    EXPECT_TRUE(is_near(colour_at(canvas, view.to_px({0.02, 0.01})), white_on_black.outline));
    EXPECT_TRUE(is_black(colour_at(canvas, view.to_px({0.0, 0.01}))));
}

TEST(PaintOutlines, ACoarseLevelIsTheCoarsePolyline) {
    const CurveSet curves = curves_of({circle(0.03)});
    const int coarsest = curves.coarsest();
    ASSERT_GT(coarsest, 2);
    const Canvas canvas = blank();
    paint_outlines(canvas.context(), view, curves, coarsest, 4.0, {white_on_black.outline});
    const Segment segment = curves.rendered_segment(0, coarsest, 0);
    const Position middle = 0.5 * (segment.a + segment.b);
    EXPECT_TRUE(is_near(colour_at(canvas, view.to_px(middle)), white_on_black.outline));
    EXPECT_LT(norm(middle), 0.029);  // well inside the circle, where level 0 draws nothing
}

Picture one_colour(int picture_width, int picture_height) {
    Picture picture;
    picture.width = picture_width;
    picture.height = picture_height;
    picture.bgr.assign(3 * static_cast<std::size_t>(picture_width * picture_height), 255);
    return picture;
}

TEST(PaintPicture, LiesCentredInTheAreaDimmedAndInItsOwnShape) {
    const Canvas canvas = blank();
    paint_picture(canvas.context(), view, Area{}, canvas_of(one_colour(40, 80), 1600));
    const Colour dimmed{white_on_black.picture_alpha, white_on_black.picture_alpha,
                        white_on_black.picture_alpha};
    EXPECT_TRUE(is_near(colour_at(canvas, view.to_px({0.0, 0.0})), dimmed));
    EXPECT_TRUE(is_near(colour_at(canvas, view.to_px({0.020, 0.041})), dimmed));
    EXPECT_TRUE(is_black(colour_at(canvas, view.to_px({0.022, 0.0}))));
}

TEST(PaintPicture, RedStaysRed) {
    Picture picture = one_colour(4, 3);
    for (std::size_t i = 0; i < picture.bgr.size(); i += 3)
        picture.bgr[i] = picture.bgr[i + 1] = 0;  // blue and green
    const Canvas canvas = blank();
    paint_picture(canvas.context(), view, Area{}, canvas_of(picture, 1600));
    const Colour middle = colour_at(canvas, view.to_px({0.0, 0.0}));
    EXPECT_NEAR(middle.red, white_on_black.picture_alpha, 0.02);
    EXPECT_NEAR(middle.blue, 0.0, 0.02);
}

TEST(CanvasOf, ALargePictureIsMadeSmall) {
    const Canvas canvas = canvas_of(one_colour(3000, 1500), 1000);
    EXPECT_EQ(canvas.width(), 1000);
    EXPECT_EQ(canvas.height(), 500);
    EXPECT_TRUE(is_near(colour_at(canvas, {999.5, 499.5}), {1.0, 1.0, 1.0}));
}

TEST(CanvasOf, AndBackIsTheSamePicture) {
    Picture picture = one_colour(7, 5);
    for (std::size_t i = 0; i < picture.bgr.size(); ++i)
        picture.bgr[i] = static_cast<std::uint8_t>(2 * i);
    const Picture back = picture_of(canvas_of(picture, 1600));
    EXPECT_EQ(back.width, 7);
    EXPECT_EQ(back.height, 5);
    EXPECT_EQ(back.bgr, picture.bgr);
}

TEST(PaintPath, FollowsItsPointsAndLeavesOutWhatIsNotFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::array<Position, 4> path{
        Position{-0.02, 0.01}, {nan, 0.0}, {0.02, 0.01}, {0.02, 0.0}};
    const Canvas canvas = blank();
    paint_path(canvas.context(), view, path, 4.0, {white_on_black.proxy});
    EXPECT_TRUE(is_near(colour_at(canvas, view.to_px({0.0, 0.01})), white_on_black.proxy));
    EXPECT_TRUE(is_near(colour_at(canvas, view.to_px({0.02, 0.005})), white_on_black.proxy));
}

TEST(PaintForces, AnArrowPointsTheWayTheHandIsPushed) {
    const std::array<ForceMark, 1> up{ForceMark{{0.0, 0.0}, {0.0, 1.0}}};
    const Canvas canvas = blank();
    paint_forces(canvas.context(), view, up, 100.0, 4.0);
    EXPECT_TRUE(is_near(colour_at(canvas, view.to_px({0.0, 0.005})), white_on_black.force));
    EXPECT_TRUE(is_black(colour_at(canvas, view.to_px({0.0, -0.002}))));
}

TEST(PaintForces, NoForceIsNoArrow) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::array<ForceMark, 3> none{ForceMark{{0.0, 0.0}, {0.0, 0.01}},
                                        ForceMark{{0.0, 0.0}, {nan, 1.0}},
                                        ForceMark{{nan, 0.0}, {0.0, 1.0}}};
    const Canvas canvas = blank();
    paint_forces(canvas.context(), view, none, 100.0, 4.0);
    EXPECT_EQ(ink_of(canvas), Rect{});
}

}  // namespace
}  // namespace touchline
