// Tests the operator's levels and detail through the whole kiosk, from the key to the force on the
// handle.
#include "tests/app/kiosk/blind_visitor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr int most_level = 16;
constexpr double least_told = 1e-6;  // for levels, and in metres for places

constexpr Position middle{0.0, 0.0};  // of "A heart" and "A circle"

double distance_m(Position p, const Segment& segment) {
    const Position way = segment.b - segment.a;
    const double length2_m2 = dot(way, way);
    const double share =
        length2_m2 > 0.0 ? std::clamp(dot(p - segment.a, way) / length2_m2, 0.0, 1.0) : 0.0;
    return norm(p - (segment.a + share * way));
}

/// The distance to the curves as they are rendered at a level.
double distance_m(Position p, const CurveSet& curves, double level) {
    double least_m = std::numeric_limits<double>::infinity();
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        for (int j = 0; j < curves.rendered_count(piece, level); ++j)
            least_m = std::min(least_m, distance_m(p, curves.rendered_segment(piece, level, j)));
    }
    return least_m;
}

/// A place behind the outline, seen from the middle, where its coarsest level is farthest from its
/// finest.
Position behind_line(KioskWorld& world) {
    constexpr double push_m = 0.003;
    const CurveSet& curves = world.servo().picture().scene->curves;
    Position place;
    double most_m = 0.0;
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        for (const Position& p : curves.points(piece, 0)) {
            const double moved_m = distance_m(p, curves, curves.coarsest());
            if (moved_m > most_m) place = p;
            most_m = std::max(most_m, moved_m);
        }
    }
    return (1.0 + push_m / norm(place)) * place;
}

/// The level that acts if the operator fixes `set`: device, proxy, time and picture take
/// precedence.
double possible_level(KioskWorld& world, int set) {
    LevelTerms terms = world.kiosk().hand().level_terms;
    terms.finest = terms.coarsest = set;
    return choose_level(terms).level;
}

void expect_wall_of_level(KioskWorld& world, double level) {
    const HandState& hand = world.kiosk().hand();
    world.run(0.5);  // until the hand has come to rest
    for (int i = 0; i < 10 && std::abs(hand.level - level) > least_told; ++i) world.run(0.5);
    EXPECT_NEAR(hand.level, level, least_told);
    EXPECT_NE(hand.state, ContactState::free);
    const double radius_m = world.servo().commands().contact.radius_m;
    EXPECT_NEAR(distance_m(hand.p_WP, world.servo().picture().scene->curves, level), radius_m,
                least_told);
    EXPECT_NEAR(norm(world.servo().force_on_handle_W()),
                hand.stiffness_N_per_m * norm(hand.p_WP - hand.p_WH), 0.02);
}

void hold_level(KioskWorld& world, BlindVisitor& staff, const char* setting,
                const char* picture = "A heart") {
    ASSERT_NO_FATAL_FAILURE(open_walls(world, picture));
    ASSERT_NO_FATAL_FAILURE(hold_setting(staff, {"How it feels", "Levels", setting}));
}

/// The visit goes on; the wall under the hand moves to that of the level.
TEST(FeltLevel, IsEveryFixedLevelThatTheOperatorCanSet) {
    WallWorld world;
    BlindVisitor staff(world, 0.2);
    ASSERT_NO_FATAL_FAILURE(hold_level(world, staff, "Level follows the hand"));
    ASSERT_FALSE(world.servo().commands().is_level_auto);
    ASSERT_TRUE(staff.choose("Fixed level")) << staff.heard();
    ASSERT_NO_FATAL_FAILURE(turn_to_least(staff));
    const Position behind = behind_line(world);
    double least_m = norm(behind);
    double most_m = 0.0;
    for (int set = 0; set <= most_level; ++set) {
        SCOPED_TRACE(set);
        EXPECT_EQ(world.servo().commands().level, set);
        lead_hand(world, behind);
        const double level = possible_level(world, set);
        expect_wall_of_level(world, level);
        least_m = std::min(least_m, norm(world.kiosk().hand().p_WP));
        most_m = std::max(most_m, norm(world.kiosk().hand().p_WP));
        const std::string told = std::to_string(set) + " set, " +
                                 std::to_string(static_cast<int>(level)) +
                                 " possible in this picture";
        const bool is_told = staff.heard().find(told) != std::string::npos;
        EXPECT_EQ(is_told, set > 0 && level != set) << staff.heard();
        lead_hand(world, middle);
        staff.press(KeyRole::up);
    }
    EXPECT_GT(most_m - least_m, 1e-4) << "a coarser level is another wall";
    EXPECT_EQ(world.kiosk().force().fault, Fault::none);
}

/// A hand that stands still feels the finest level.
TEST(FeltLevel, GetsNoFinerThanEveryFinestLevelThatTheOperatorCanSet) {
    WallWorld world;
    BlindVisitor staff(world, 0.2);
    ASSERT_NO_FATAL_FAILURE(hold_level(world, staff, "Finest level"));
    ASSERT_NO_FATAL_FAILURE(turn_to_least(staff));
    const Position behind = behind_line(world);
    for (int set = 0; set <= most_level; ++set) {
        SCOPED_TRACE(set);
        EXPECT_EQ(world.servo().commands().finest_level, set);
        lead_hand(world, behind);
        world.run(1.0);
        const LevelTerms& terms = world.kiosk().hand().level_terms;
        EXPECT_EQ(terms.speed, 0.0);
        EXPECT_EQ(terms.finest, set);
        expect_wall_of_level(world,
                             possible_level(world, std::max(set, static_cast<int>(terms.percept))));
        lead_hand(world, middle);
        staff.press(KeyRole::up);
    }
}

/// Level 1 of a circle feels the same as level 0, so it acts unless the operator forbids it.
TEST(FeltLevel, GetsNoCoarserThanEveryCoarsestLevelThatTheOperatorCanSet) {
    WallWorld world;
    BlindVisitor staff(world, 0.2);
    ASSERT_NO_FATAL_FAILURE(hold_level(world, staff, "Coarsest level", "A circle"));
    const Position behind = behind_line(world);
    int decided = 0;
    for (int set = most_level; set >= 0; --set) {
        SCOPED_TRACE(set);
        EXPECT_EQ(world.servo().commands().coarsest_level, set);
        lead_hand(world, behind);
        world.run(1.0);
        const LevelTerms& terms = world.kiosk().hand().level_terms;
        EXPECT_EQ(terms.coarsest, set);
        EXPECT_LE(world.kiosk().hand().level, possible_level(world, set) + least_told);
        const LevelChoice chosen = choose_level(terms);
        decided += chosen.by == LevelTerm::coarsest ? 1 : 0;
        expect_wall_of_level(world, chosen.level);
        lead_hand(world, middle);
        staff.press(KeyRole::down);
    }
    EXPECT_GT(decided, 0) << "else the bound is not tried at all";
}

/// A line of "A house" and how the hand meets it, starting from a place that is free at every
/// detail.
struct LineOfHouse {
    int detail;
    Position free;
    Position behind;
    Position along;
};

constexpr std::array lines{
    LineOfHouse{1, {-0.0345, -0.005}, {-0.0406, -0.005}, {0.0, -0.004}},   // left wall
    LineOfHouse{2, {-0.018, -0.003}, {-0.018, 0.0046}, {0.004, 0.0}},      // eaves
    LineOfHouse{3, {-0.0345, -0.012}, {-0.0284, -0.012}, {0.0, -0.004}},   // left window
    LineOfHouse{4, {0.0, 0.006}, {0.0, 0.0126}, {0.001, 0.0}},             // round window
    LineOfHouse{5, {-0.027, -0.0125}, {-0.0209, -0.0125}, {0.0, -0.001}},  // its bars
};

class FeltDetail : public testing::TestWithParam<int> {};

/// The visit goes on: lines above the detail are not felt, all others are walls.
TEST_P(FeltDetail, IsEveryValueThatTheOperatorCanSet) {
    WallWorld world;
    BlindVisitor staff(world, 0.2);
    ASSERT_NO_FATAL_FAILURE(open_walls(world, "A house"));
    ASSERT_NO_FATAL_FAILURE(hold_setting(staff, {"How it feels", "Detail of pictures", "Detail"}));
    for (const LineOfHouse& line : lines) {
        SCOPED_TRACE(line.detail);
        ASSERT_NO_FATAL_FAILURE(turn_to_least(staff));
        world.run(1.0);
        lead_hand(world, {line.free.x, 0.0});
        lead_hand(world, line.free);
        for (int detail = 1; detail < GetParam(); ++detail) staff.press(KeyRole::up);
        world.run(2.0);
        EXPECT_EQ(world.kiosk().visit().visitor.felt->order.detail, GetParam());
        const FeltWall felt = feel_wall(world, line.behind, line.along);
        if (line.detail <= GetParam())
            EXPECT_NEAR(felt.stiffness_N_per_m, 500.0, 15.0);
        else
            EXPECT_LT(felt.most_force_N, 0.01);
    }
    EXPECT_EQ(open_screen(world.kiosk().visit()), VisitScreen::help) << "nothing was moved";
    EXPECT_EQ(world.kiosk().force().fault, Fault::none);
}

INSTANTIATE_TEST_SUITE_P(All, FeltDetail, testing::Range(1, 6));

}  // namespace
}  // namespace touchline
