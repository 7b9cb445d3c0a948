#include "config/types/map_frame.h"

#include <charconv>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

/// Writes the shortest text that reads back, as an SVG writer does, and reads it.
double written_and_read(double value) {
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    double read = std::numeric_limits<double>::quiet_NaN();
    std::from_chars(text, end, read);
    return read;
}

double drawn_mm(int low_um, int high_um) {
    return *rc::gen::inRange(low_um, high_um) / 1000.0 + *rc::gen::inRange(0, 1000000) / 1e9;
}

TEST(MapFrame, OriginIsTheCentreAndYPointsAway) {
    const Area area;
    EXPECT_EQ(view_box_of(area), (ViewBox{0.0, 0.0, 116.0, 84.0}));
    EXPECT_EQ(from_view_box(58.0, 42.0, view_box_of(area)), (Position{0.0, 0.0}));
    EXPECT_EQ(from_view_box(116.0, 0.0, view_box_of(area)), (Position{0.058, 0.042}));
    EXPECT_EQ(from_view_box(13.0, 25.0, {3.0, 5.0, 20.0, 40.0}), (Position{0.0, 0.0}));
}

TEST(MapFrame, AreaAndViewBoxAgreeAfterOneRound) {
    const Area area{0.1160000001234, 0.08399999998765};
    const Area kept = area_of(view_box_of(area));
    EXPECT_EQ(area_of(view_box_of(kept)), kept);
    EXPECT_EQ(area_of(view_box_of(Area{})), Area{});
}

RC_GTEST_PROP(MapFrame, CanonicalPointsReadBackBitForBit, ()) {
    const Area area = area_of(
        view_box_of(Area{drawn_mm(1000, 900000) / 1000.0, drawn_mm(1000, 900000) / 1000.0}));
    const ViewBox box = view_box_of(area);
    const Position point = canonical_point(drawn_mm(0, 900000), drawn_mm(-900000, 900000), area);
    const ViewBoxPoint written = to_view_box(point, box);
    const ViewBox read_box{0.0, 0.0, written_and_read(box.width_mm),
                           written_and_read(box.height_mm)};
    RC_ASSERT(from_view_box(written_and_read(written.u_mm), written_and_read(written.v_mm),
                            read_box) == point);
    RC_ASSERT(area_of(read_box) == area);
    RC_ASSERT(on_nanometre_grid_mm(written.u_mm) == written.u_mm);
    RC_ASSERT(on_nanometre_grid_mm(written.v_mm) == written.v_mm);
}

RC_GTEST_PROP(MapFrame, AnyPointComesBackWithinAPicometre, ()) {
    const ViewBox box{drawn_mm(-5000, 5000), drawn_mm(-5000, 5000), drawn_mm(1000, 900000),
                      drawn_mm(1000, 900000)};
    const double u_mm = drawn_mm(-900000, 900000);
    const double v_mm = drawn_mm(-900000, 900000);
    const ViewBoxPoint back = to_view_box(from_view_box(u_mm, v_mm, box), box);
    RC_ASSERT(std::abs(back.u_mm - u_mm) < 1e-9);
    RC_ASSERT(std::abs(back.v_mm - v_mm) < 1e-9);
}

}  // namespace
}  // namespace touchline
