// What a line does by its distance, and the bead on it that the hand is tied to, each on its own.
#include "haptics/contact/groove.h"
#include "tests/haptics/contact/hold_rig.h"
#include "tests/haptics/scenes.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using scenes::map_of;
using scenes::outline;

constexpr double mm = 1e-3;
constexpr double far_m = 1.0;

TEST(CaptureLaw, TheForceIsTheSlopeOfTheEnergy) {
    for (const Mode mode : hold_modes) {
        const CaptureLaw law(settings_of(mode));
        constexpr double step_m = 1e-7;
        for (double d = 1e-5; d < 1.5 * law.capture_m(); d += 1e-4) {
            const double slope_N =
                (law.energy_J(d + step_m) - law.energy_J(d - step_m)) / (2.0 * step_m);
            EXPECT_NEAR(law.pull_N(d), slope_N, 1e-4) << static_cast<int>(mode) << ' ' << d;
        }
    }
}

/// The energy is zero where the hand would come to rest.
TEST(CaptureLaw, TheEnergyIsZeroWhereTheForceLeads) {
    EXPECT_EQ(CaptureLaw(settings_of(Mode::groove)).energy_J(0.0), 0.0);
    EXPECT_EQ(CaptureLaw(settings_of(Mode::stay)).energy_J(0.0), 0.0);
    const CaptureLaw ridge(settings_of(Mode::ridge));
    EXPECT_EQ(ridge.energy_J(ridge.capture_m()), 0.0);
    EXPECT_GT(ridge.energy_J(0.0), 0.0);
}

TEST(CaptureLaw, BeyondItsWidthALineHasNoForce) {
    for (const Mode mode : hold_modes) {
        const CaptureLaw law(settings_of(mode));
        EXPECT_EQ(law.pull_N(1.001 * law.capture_m()), 0.0);
        EXPECT_EQ(law.pull_N(std::numeric_limits<double>::quiet_NaN()), 0.0);
        EXPECT_EQ(law.energy_J(5.0 * law.capture_m()), law.energy_J(law.capture_m()));
    }
}

/// One line and the bead on it.
class Bead {
  public:
    Bead(const std::vector<Position>& points, Attachment at)
        : scene_(scene_of(map_of({outline(points, false)}))), outlines_(scene_, 0.0), at_(at) {}

    Position slide(Position hand, double longest_m, double longest_hop_m = 0.0) {
        at_ = slid(outlines_, at_, hand, longest_m, longest_hop_m);
        return point_of(outlines_, at_);
    }

  private:
    Scene scene_;
    RenderedOutlines outlines_;
    Attachment at_;
};

const std::vector<Position> straight_way{
    {0.0, 0.0}, {10.0 * mm, 0.0}, {20.0 * mm, 0.0}, {30.0 * mm, 0.0}, {40.0 * mm, 0.0}};

TEST(Attachment, SlidesBelowTheHandAndNoFurtherThanItMay) {
    Bead bead(straight_way, {{0, 0}, 0.5});
    EXPECT_NEAR(bead.slide({33.0 * mm, mm}, 3.0 * mm).x, 8.0 * mm, 1e-12);
    EXPECT_NEAR(bead.slide({33.0 * mm, mm}, 14.0 * mm).x, 22.0 * mm, 1e-12);
    EXPECT_NEAR(bead.slide({33.0 * mm, mm}, far_m).x, 33.0 * mm, 1e-12);
    EXPECT_NEAR(bead.slide({2.0 * mm, -mm}, 15.0 * mm).x, 18.0 * mm, 1e-12);
    EXPECT_NEAR(bead.slide({2.0 * mm, -mm}, far_m).x, 2.0 * mm, 1e-12);
    EXPECT_NEAR(bead.slide({90.0 * mm, mm}, far_m).x, 40.0 * mm, 1e-12);  // the line's end
}

/// From one side of a hollow the way to the other leads past the vertex, which is farther away.
TEST(Attachment, HopsInsideABendAsFarAsItMay) {
    const std::vector<Position> hollow{{-10.0 * mm, 10.0 * mm}, {0.0, 0.0}, {10.0 * mm, 10.0 * mm}};
    const Position hand{0.5 * mm, 5.0 * mm};
    const double to_vertex_m = norm(Position{2.25 * mm, 2.25 * mm});  // from the foot on the left
    const double from_vertex_m = norm(Position{2.75 * mm, 2.75 * mm});
    Bead bead(hollow, {{0, 0}, 0.7});
    const double hop_m = to_vertex_m + from_vertex_m;
    EXPECT_NEAR(bead.slide(hand, far_m, 0.99 * hop_m).x, -2.25 * mm, 1e-12);
    EXPECT_NEAR(bead.slide(hand, far_m, 1.01 * hop_m).x, 2.75 * mm, 1e-12);
    EXPECT_NEAR(bead.slide({-0.5 * mm, 5.0 * mm}, far_m, 0.99 * hop_m).x, 2.25 * mm, 1e-12);
    EXPECT_NEAR(bead.slide({-0.5 * mm, 5.0 * mm}, far_m, 1.01 * hop_m).x, -2.75 * mm, 1e-12);
}

/// Round the inside of a bow every edge is a little nearer to a hand that lies off its middle.
TEST(Attachment, AllHopsOfATickTogetherAreLimited) {
    std::vector<Position> bow;
    for (int i = 0; i <= 8; ++i) {
        const double angle = 0.3 * i;
        bow.push_back(10.0 * mm * Position{std::cos(angle), std::sin(angle)});
    }
    const double middle = 0.3 * 7.5;
    const Position hand = 0.3 * mm * Position{std::cos(middle), std::sin(middle)};
    const double edge_m = 20.0 * mm * std::sin(0.15);
    Bead free(bow, {{0, 0}, 0.5});
    const Position goal = free.slide(hand, far_m, far_m);
    Bead bead(bow, {{0, 0}, 0.5});
    const Position one = bead.slide(hand, far_m, 1.9 * edge_m);
    const Position two = bead.slide(hand, far_m, 1.9 * edge_m);
    EXPECT_GT(norm(goal - one), 4.0 * edge_m);
    EXPECT_LT(norm(goal - two), norm(goal - one) - 0.5 * edge_m);
    EXPECT_NEAR(std::atan2(goal.y, goal.x), middle, 1e-9);
}

/// Tries every place, the ends too, of every piece between two corners.
TEST(Attachment, KeepsItsPlaceWhereTheLevelChanges) {
    std::vector<Position> points;
    for (int i = 0; i <= 32; ++i) points.push_back({mm * i, 0.2 * mm * std::sin(0.4 * i)});
    for (int i = 1; i <= 32; ++i) points.push_back({32.0 * mm, mm * i});
    const Scene scene = scene_of(map_of({outline(points, false)}));
    ASSERT_GE(scene.curves.pieces().size(), 2U);
    for (int piece = 0; piece < static_cast<int>(scene.curves.pieces().size()); ++piece) {
        for (const double from : {0.0, 1.5, 2.0}) {
            for (const double to : {0.0, 0.5, 2.0, 3.0}) {
                const int count = scene.curves.rendered_count(piece, from);
                for (int j = 0; j < count; ++j) {
                    for (const double share : {0.0, 0.4, 1.0}) {
                        const Attachment at = at_level(scene.curves, {{piece, j}, share}, from, to);
                        EXPECT_EQ(at.segment.piece, piece);
                        EXPECT_NEAR(scene.curves.outline_parameter(piece, to, at.segment.index,
                                                                   at.parameter),
                                    scene.curves.outline_parameter(piece, from, j, share), 1e-12);
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace touchline
