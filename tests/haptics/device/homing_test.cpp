// Homing: a hand that follows the words, and hands that do not.
#include "haptics/device/homing.h"

#include "config/types/angle.h"
#include "haptics/pantograph/kinematics.h"
#include "haptics/pantograph/profile.h"
#include "tests/haptics/tick.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr JointAngles retracted{radians(168.0), radians(12.0)};
constexpr JointAngles extended{radians(97.23), radians(82.77)};
const HomingPlan gen31 = homing_plan(default_profile());
constexpr JointAngles aside =
    extended + JointAngles{radians(-30.0), radians(-30.0)};  // to the left

// "No": to the right.
constexpr JointAngles answer_no = extended + JointAngles{radians(30.0), radians(30.0)};

Calibration known() {
    Calibration stored;
    stored.is_measured = true;
    return stored;
}

/// Where a hand goes and how long it stays.
struct Stay {
    JointAngles at;
    double rest_s = 0.0;
};

/// Encoders that start counting at home wherever the arms are, as the board's do.
struct Unit {
    double scale = 1.0;                 // true turn per turn read
    JointAngles told_home = retracted;  // angles at which the set-up was sent
    Plugs encoders;

    [[nodiscard]] JointAngles read(JointAngles angles) const {
        const auto count = [&](double turn, double quantum) {
            return quantum * std::trunc(turn / scale / quantum);
        };
        return retracted +
               at_ports(encoders, JointAngles{count(angles.x - told_home.x, gen31.quantum.x),
                                              count(angles.y - told_home.y, gen31.quantum.y)});
    }
};

/// Goes from stay to stay at 1 rad/s and trembles by a tenth of a degree.
HomingView lead(Homing& homing, const Unit& unit, const std::vector<Stay>& stays) {
    HomingView view;
    // Every way begins with a small motion to and fro, as the first words ask for.
    JointAngles at = stays.front().at + 0.1 * (extended - retracted);
    double t_s = 0.0;
    const auto tick = [&] {
        t_s += tick_s;
        const double tremble = radians(0.1) * std::sin(60.0 * t_s);
        view = homing.step(unit.read(at + JointAngles{tremble, -tremble}), tick_s);
    };
    for (const Stay& stay : stays) {
        while (norm(stay.at - at) > tick_s) {
            at += tick_s / norm(stay.at - at) * (stay.at - at);
            tick();
        }
        at = stay.at;
        for (double s = 0.0; s < stay.rest_s; s += tick_s) tick();
    }
    return view;
}

JointAngles between(double share) {
    return retracted + share * (extended - retracted);
}

TEST(Homing, OneWayIsEnoughWhereTheScaleIsKnown) {
    Homing homing(gen31, known());
    EXPECT_EQ(lead(homing, {}, {{retracted, 4.5}}).step, HomingStep::to_check);
    const HomingView view = lead(homing, {}, {{retracted, 0.1}, {extended, 4.5}});
    EXPECT_EQ(view.step, HomingStep::done);
    EXPECT_EQ(view.remark, HomingRemark::none);
    EXPECT_LT(view.misfit_m, 1e-3);
}

TEST(Homing, ShiftsWhatTheBoardTellsToWhereTheArmsAre) {
    // The board was set up with the handle 20 degrees from home.
    const Unit unit{1.0, between(0.3), {}};
    Homing homing(gen31, known());
    ASSERT_EQ(lead(homing, unit, {{retracted, 4.5}, {extended, 4.5}}).step, HomingStep::done);
    const Calibration found = homing.calibration();
    const JointAngles middle = retracted + found.offset + (unit.read(between(0.5)) - retracted);
    EXPECT_NEAR(middle.x, between(0.5).x, radians(0.4));
    EXPECT_NEAR(middle.y, between(0.5).y, radians(0.4));
}

TEST(Homing, MeasuresTheScaleOfAUnitByTwoVisits) {
    for (const double scale : {1.02, 0.985, 1.19, 0.5, 0.595}) {
        const Unit unit{scale, retracted, {}};
        Homing homing(gen31, {});
        const HomingView half = lead(homing, unit, {{retracted, 4.5}, {extended, 4.5}});
        EXPECT_EQ(half.step, HomingStep::to_left) << scale;
        const HomingView view = lead(
            homing, unit,
            {{extended, 0.1}, {aside, 4.5}, {retracted, 4.5}, {extended, 4.5}, {answer_no, 4.5}});
        EXPECT_EQ(view.step, HomingStep::done) << scale;
        EXPECT_EQ(view.remark, HomingRemark::measured);
        EXPECT_TRUE(homing.calibration().is_measured);
        EXPECT_NEAR(homing.calibration().scale / scale, 1.0, 0.01);
        EXPECT_LT(norm(homing.calibration().stop_off), radians(0.5));
    }
}

TEST(Homing, AScaleThatNoUnitIsKnownForIsSaidToBeAnotherKind) {
    for (const double scale : {0.855, 0.95, 1.05, 1.09, 0.7, 0.42, 1.4}) {
        Homing homing(gen31, {});
        const Unit unit{scale, retracted, {}};
        EXPECT_EQ(lead(homing, unit, {{retracted, 4.5}, {extended, 4.5}}).remark,
                  HomingRemark::misfit)
            << scale;
        const HomingView view = lead(homing, unit, {{extended, 45.0}});
        EXPECT_EQ(view.remark, HomingRemark::no_such_scale) << scale;
        EXPECT_NEAR(view.turn_share, 1.0 / scale, 0.02 / scale);
    }
}

/// The stops of the two arms are at different places, but both encoders are alike.
TEST(Homing, WhatDiffersBetweenTheJointsIsTheStop) {
    const JointAngles stop{radians(166.58), radians(11.11)};
    Homing homing(gen31, {});
    ASSERT_EQ(lead(homing, {},
                   {{stop, 4.5},
                    {extended, 4.5},
                    {aside, 4.5},
                    {stop, 4.5},
                    {extended, 4.5},
                    {answer_no, 4.5}})
                  .step,
              HomingStep::done);
    const Calibration found = homing.calibration();
    EXPECT_NEAR(found.scale, 1.0, 0.006);
    EXPECT_LT(norm(retracted + found.stop_off - stop), radians(0.6));
    Homing again(gen31, found);
    EXPECT_EQ(lead(again, {}, {{stop, 4.5}, {extended, 4.5}}).step, HomingStep::done);
}

TEST(Homing, DoesNotTakeAPauseOnTheWayForTheStop) {
    // 98 % of the way is within the error that a scale may have. The second visit reveals it.
    Homing homing(gen31, {});
    const HomingView view = lead(
        homing, {},
        {{retracted, 4.5}, {between(0.98), 4.5}, {aside, 4.5}, {retracted, 4.5}, {extended, 4.5}});
    EXPECT_EQ(view.step, HomingStep::to_check_again);
    EXPECT_EQ(view.remark, HomingRemark::misfit);
}

TEST(Homing, WhoDoesNotGoAsideIsAskedAgain) {
    Homing homing(gen31, {});
    const HomingView view =
        lead(homing, {}, {{retracted, 4.5}, {extended, 4.5}, {between(0.7), 4.5}});
    EXPECT_EQ(view.step, HomingStep::to_left);
    EXPECT_EQ(view.remark, HomingRemark::not_left);
}

TEST(Homing, AMisfitIsToldAndTheHandMayGoOn) {
    const Unit unit;
    Homing homing(gen31, known());
    const HomingView pause = lead(homing, unit, {{retracted, 4.5}, {between(0.5), 4.5}});
    EXPECT_EQ(pause.step, HomingStep::to_check);
    EXPECT_EQ(pause.remark, HomingRemark::misfit);
    EXPECT_NEAR(pause.misfit_m, 0.5 * radians(70.77) * 0.070, 1e-3);
    EXPECT_EQ(lead(homing, unit, {{between(0.5), 0.1}, {extended, 4.5}}).step, HomingStep::done);
}

TEST(Homing, AScaleThatIsOffByMoreThanThreeMillimetresGivesNoForce) {
    Homing homing(gen31, known());
    // 5 % of 70.8 degrees on 70 mm are 4.3 mm; 3 % are 2.6 mm.
    EXPECT_EQ(lead(homing, {1.05, retracted, {}}, {{retracted, 4.5}, {extended, 4.5}}).step,
              HomingStep::to_check);
    Homing other(gen31, known());
    EXPECT_EQ(lead(other, {1.03, retracted, {}}, {{retracted, 4.5}, {extended, 4.5}}).step,
              HomingStep::done);
}

TEST(Homing, ThreeMisfitsStartOver) {
    Homing homing(gen31, known());
    const HomingView view =
        lead(homing, {},
             {{retracted, 4.5}, {between(0.4), 4.5}, {between(0.5), 4.5}, {between(0.6), 2.0}});
    EXPECT_EQ(view.step, HomingStep::to_home);
    EXPECT_EQ(view.remark, HomingRemark::starting_over);
}

/// Homing recognizes every way to plug in the encoders once it has seen it twice.
TEST(Homing, FindsWhereAndWhichWayRoundTheEncodersAre) {
    for (std::uint32_t number = 0; number < 8; ++number) {
        const Unit unit{1.0, retracted, plugs_of(number)};
        Homing homing(gen31, {});
        HomingView view;
        const std::vector<Stay> round{{retracted, 4.5}, {extended, 4.5}, {aside, 4.5}};
        if (number != 0) {
            EXPECT_EQ(lead(homing, unit, round).remark, HomingRemark::reversed) << number;
        }
        EXPECT_EQ(lead(homing, unit, round).step, HomingStep::to_home_again) << number;
        view =
            lead(homing, unit, {{aside, 0.1}, {retracted, 4.5}, {extended, 4.5}, {answer_no, 4.5}});
        ASSERT_EQ(view.step, HomingStep::done) << number;
        EXPECT_EQ(at_joints(homing.calibration().encoders,
                            at_ports(unit.encoders, JointAngles{1.0, 2.0})),
                  (JointAngles{1.0, 2.0}))
            << number;
    }
}

TEST(Homing, AKnownUnitIsRecognizedHoweverItsEncodersAre) {
    for (std::uint32_t number = 0; number < 8; ++number) {
        Calibration stored = known();
        stored.encoders = plugs_of(number);
        Homing homing(gen31, stored);
        const Unit unit{1.0, retracted, plugs_of(number)};
        const HomingView view = lead(homing, unit, {{retracted, 4.5}, {extended, 4.5}});
        EXPECT_EQ(view.step, HomingStep::done) << number;
        EXPECT_EQ(view.remark, HomingRemark::none) << number;
    }
}

/// 168 degrees and as many counts as usual read like 180 degrees and 4096 counts.
TEST(Homing, WhatAnotherKindWouldReadTooIsAsked) {
    const DeviceProfile kind_180 = find_profile("2diy-gen3.1-180").value();
    for (const bool is_chosen_180 : {false, true}) {
        for (const bool is_unit_180 : {false, true}) {
            Homing homing(is_chosen_180 ? homing_plan(kind_180) : gen31, {});
            const JointAngles stop = is_unit_180 ? kind_180.home : retracted;
            const Unit unit{is_unit_180 ? 4880.0 / 4096.0 : 1.0, stop, {}};
            const HomingView asked =
                lead(homing, unit,
                     {{stop, 4.5}, {extended, 4.5}, {aside, 4.5}, {stop, 4.5}, {extended, 4.5}});
            EXPECT_EQ(asked.step, HomingStep::to_answer);
            // A rest at the stop, while the other hand feels the arms, is no answer.
            EXPECT_EQ(lead(homing, unit, {{stop, 8.0}}).prompts, asked.prompts);
            const HomingView view = lead(homing, unit, {{is_unit_180 ? aside : answer_no, 4.5}});
            EXPECT_EQ(view.remark, is_chosen_180 == is_unit_180 ? HomingRemark::measured
                                                                : HomingRemark::other_kind);
            EXPECT_EQ(homing.calibration().is_measured, is_chosen_180 == is_unit_180);
        }
    }
}

/// At 5.6 per cent no question that fingers can answer tells these apart, so the nearest count
/// does.
TEST(Homing, KindsThatBendAlikeAreToldApartByTheNearestCount) {
    const HomingPlan plan_172 = homing_plan(find_profile("2diy-gen3.1-172").value());
    const HomingPlan plan_3 = homing_plan(find_profile("2diy-gen3").value());
    const auto step_of = [](const HomingPlan& plan, const Unit& unit, JointAngles stop) {
        Homing homing(plan, {});
        const JointAngles first = plan.is_home_stretched ? extended : stop;
        const JointAngles second = plan.is_home_stretched ? stop : extended;
        return lead(homing, unit, {{first, 4.5}, {second, 4.5}}).step;
    };
    const double gen3_counts = 0.5 * (2048.0 * 2.5 * 1.0194 * 2.0154);
    const JointAngles stop_172 = plan_172.home;
    EXPECT_EQ(step_of(plan_172, {}, stop_172), HomingStep::to_left);
    EXPECT_EQ(step_of(plan_172, {}, retracted), HomingStep::to_check);
    EXPECT_EQ(step_of(gen31, {}, stop_172), HomingStep::to_check);
    EXPECT_EQ(step_of(plan_3, {gen3_counts / 4880.0, retracted, {}}, stop_172),
              HomingStep::to_check);
    EXPECT_EQ(step_of(plan_172, {4880.0 / gen3_counts, retracted, {}}, retracted),
              HomingStep::to_check);
}

/// The decoder reports a millimetre for each half of one.
TEST(Homing, ADecoderThatDoublesAllowsAHandThatIsAsSoft) {
    const Unit unit{0.5, retracted, {}};
    const auto elbow_off = [](double off_m) {
        return retracted + off_m / gen31.arm_m * JointAngles{-1.0, 1.0};
    };
    Homing homing(gen31, {});
    const std::vector<Stay> round{{retracted, 4.5}, {extended, 4.5}, {aside, 4.5}};
    ASSERT_EQ(lead(homing, unit, round).step, HomingStep::to_home_again);
    const HomingView off = lead(homing, unit, {{aside, 0.1}, {elbow_off(4e-3), 4.5}});
    EXPECT_EQ(off.remark, HomingRemark::misfit);
    EXPECT_NEAR(off.misfit_m, 4e-3, 0.4e-3);
    EXPECT_EQ(lead(homing, unit, {{elbow_off(9e-3), 0.1}, {elbow_off(0.7e-3), 4.5}}).step,
              HomingStep::to_check_again);
}

/// Each place that fits ends the count of those that did not.
TEST(Homing, MissesInARowStartOverAndSayNothingOfTheKindOnceThePlacesFit) {
    Homing homing(gen31, {});
    const std::vector<Stay> round{{retracted, 4.5}, {between(0.5), 4.5}, {extended, 4.5},
                                  {aside, 4.5},     {between(0.6), 4.5}, {between(0.4), 4.5}};
    EXPECT_EQ(lead(homing, {}, round).step, HomingStep::to_home_again);
    EXPECT_EQ(lead(homing, {}, {{between(0.4), 0.1}, {between(0.6), 4.5}}).remark,
              HomingRemark::starting_over);
}

TEST(Homing, AHandThatNeverRestsHearsTheWordsAgain) {
    Homing homing(gen31, known());
    const std::vector<Stay> to_and_fro{{between(0.2), 0.0}, {between(0.8), 0.0}};
    const int prompts = lead(homing, {}, to_and_fro).prompts;
    HomingView view;
    for (int k = 0; k < 70; ++k) view = lead(homing, {}, to_and_fro);
    EXPECT_EQ(view.step, HomingStep::to_home);
    EXPECT_GT(view.prompts, prompts);
}

TEST(Homing, AKnownUnitThatIsPluggedOtherwiseIsMeasuredAnewTheThirdTime) {
    const Unit unit{1.0, retracted, {true, false, false}};
    Homing homing(gen31, known());
    const std::vector<Stay> round{{retracted, 4.5}, {extended, 4.5}};
    EXPECT_EQ(lead(homing, unit, round).remark, HomingRemark::reversed);
    EXPECT_EQ(lead(homing, unit, round).remark, HomingRemark::reversed);
    EXPECT_EQ(lead(homing, unit, round).remark, HomingRemark::replugged);
    EXPECT_EQ(lead(homing, unit, round).step, HomingStep::to_left);
}

TEST(Homing, AHandThatDoesNotMoveIsAskedAgainAndAgain) {
    Homing homing(gen31, known());
    const Unit unit;
    HomingView view;
    for (int k = 0; k < 95000; ++k) view = homing.step(unit.read(retracted), tick_s);
    EXPECT_EQ(view.step, HomingStep::to_home);
    EXPECT_EQ(view.remark, HomingRemark::not_moved);
    EXPECT_EQ(view.prompts, 3);
}

TEST(Homing, AHiccupOfTheBoardIsNotSaidAndASilenceIsUntilItIsOver) {
    Homing homing(gen31, known());
    for (int k = 0; k < 400; ++k)
        EXPECT_EQ(homing.step(std::nullopt, tick_s).remark, HomingRemark::none);
    EXPECT_EQ(homing.step(retracted, tick_s).remark, HomingRemark::none);
    HomingView view;
    for (int k = 0; k < 600; ++k) view = homing.step(std::nullopt, tick_s);
    EXPECT_EQ(view.remark, HomingRemark::silent);
    EXPECT_EQ(homing.step(retracted, tick_s).remark, HomingRemark::none);
}

/// Only the order of the stops tells swapped plugs from stops in the wrong order.
TEST(Homing, StopsInTheWrongOrderAreNotSwappedPlugs) {
    for (const Calibration& stored : {known(), Calibration{}}) {
        Homing homing(gen31, stored);
        HomingView view = lead(homing, {}, {{extended, 4.5}, {retracted, 4.5}});
        if (!stored.is_measured)
            view = lead(homing, {}, {{retracted, 0.1}, {retracted + JointAngles{-0.5, -0.5}, 4.5}});
        EXPECT_EQ(view.step, HomingStep::to_home);
        EXPECT_EQ(view.remark, HomingRemark::reversed);
        view = lead(homing, {}, {{retracted, 4.5}, {extended, 4.5}});
        if (!stored.is_measured)
            view = lead(homing, {},
                        {{extended, 0.1},
                         {aside, 4.5},
                         {retracted, 4.5},
                         {extended, 4.5},
                         {answer_no, 4.5}});
        EXPECT_EQ(view.step, HomingStep::done);
        EXPECT_EQ(homing.calibration().encoders, Plugs{});
    }
}

TEST(Homing, ASilentBoardOrNoNumberIsNoRest) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const std::optional<JointAngles>& read :
         {std::optional<JointAngles>{}, std::optional<JointAngles>{{nan, 0.0}}}) {
        Homing homing(gen31, known());
        HomingView view;
        for (int k = 0; k < 20000; ++k) view = homing.step(read, tick_s);
        EXPECT_EQ(view.step, HomingStep::to_home);
        EXPECT_EQ(view.remark, HomingRemark::silent);
    }
}

/// A kind of other links whose encoders count so much that it reads the same from stop to stop as a
/// gen 3.1; bent and stretched alike on both sides of 90 degrees.
DeviceProfile reads_like_gen31(const Geometry& links, double bent_deg, double stretched_deg) {
    DeviceProfile kind = default_profile();
    kind.name = "other-links";
    kind.geometry = links;
    kind.home = {radians(bent_deg), radians(180.0 - bent_deg)};
    kind.check.angles = {radians(stretched_deg), radians(180.0 - stretched_deg)};
    const double share =
        turn_of_both_rad(extended - retracted) / turn_of_both_rad(kind.check.angles - kind.home);
    kind.counts_per_turn = share * kind.counts_per_turn;
    kind.other_counts_per_turn = 0.0;
    return kind;
}

const Geometry shorter_links{0.060, 0.085, 0.038};  // can be wherever a gen 3.1 can
const Geometry wider_links{0.060, 0.118, 0.060};    // too wide to go as far to the left

/// Everything up to where a unit is measured, or the question about its arms.
HomingView lead_to_the_end(Homing& homing, const Unit& unit, const DeviceProfile& kind,
                           double aside_deg) {
    const JointAngles left =
        kind.check.angles - JointAngles{radians(aside_deg), radians(aside_deg)};
    return lead(homing, unit,
                {{kind.home, 4.5},
                 {kind.check.angles, 4.5},
                 {left, 4.5},
                 {kind.home, 4.5},
                 {kind.check.angles, 4.5}});
}

TEST(Homing, AKindOfOtherLinksThatReadsTheSameEverywhereIsRefused) {
    const DeviceProfile other = reads_like_gen31(shorter_links, 155.0, 97.0);
    const std::vector<DeviceProfile> kinds{default_profile(), other};
    HomingPlan plan = gen31;
    plan.known = known_units(default_profile(), kinds);
    // Whichever of the two it is.
    const double other_scale = default_profile().counts_per_turn.x / other.counts_per_turn.x;
    for (const bool is_other : {false, true}) {
        Homing homing(plan, {});
        const DeviceProfile& kind = is_other ? other : default_profile();
        const Unit unit{is_other ? other_scale : 1.0, kind.home, {}};
        const HomingView view = lead_to_the_end(homing, unit, kind, 15.0);
        EXPECT_EQ(view.step, HomingStep::to_home);
        EXPECT_EQ(view.remark, HomingRemark::either_kind);
        EXPECT_FALSE(homing.calibration().is_measured);
    }
}

TEST(Homing, APlaceWhereArmsOfOneKindCannotBeTellsTheOther) {
    const DeviceProfile wide = reads_like_gen31(wider_links, 150.0, 85.0);
    ASSERT_TRUE(forward(wide.geometry, wide.home) && forward(wide.geometry, wide.check.angles));
    const std::vector<DeviceProfile> kinds{default_profile(), wide};
    HomingPlan plan = gen31;
    plan.known = known_units(default_profile(), kinds);
    Homing homing(plan, {});
    EXPECT_EQ(lead_to_the_end(homing, {}, default_profile(), 30.0).remark, HomingRemark::measured);
    // Chosen as the wide kind, the same unit is refused at the same place.
    HomingPlan wide_plan = homing_plan(wide);
    wide_plan.known = known_units(wide, kinds);
    Homing chosen_wrong(wide_plan, {});
    HomingView view;
    const double told = default_profile().counts_per_turn.x / wide.counts_per_turn.x;
    const auto read = [&](JointAngles angles) { return wide.home + told * (angles - retracted); };
    JointAngles at = retracted + 0.1 * (extended - retracted);
    for (const JointAngles stay : {retracted, extended, aside, retracted, extended}) {
        while (norm(stay - at) > tick_s) {
            at += tick_s / norm(stay - at) * (stay - at);
            view = chosen_wrong.step(read(at), tick_s);
        }
        for (double s = 0.0; s < 4.5; s += tick_s) view = chosen_wrong.step(read(at), tick_s);
    }
    EXPECT_EQ(view.remark, HomingRemark::other_kind);
    EXPECT_FALSE(chosen_wrong.calibration().is_measured);
}

/// So among the kinds that ship, only the stops are ever compared.
TEST(KnownUnits, NoTwoShippedKindsOfDifferentLinksReadTheSame) {
    for (const DeviceProfile& chosen : device_profiles()) {
        const std::vector<KnownUnits> known = known_units(chosen);
        const auto is_other = [](const KnownUnits& units) { return !units.have_own_links; };
        EXPECT_GE(std::count_if(known.begin(), known.end(), is_other), 3) << chosen.name;
        for (const KnownUnits& own : known) {
            if (!own.are_own) continue;
            for (const KnownUnits& other : known) {
                const double read = (own.turn_rad / own.scale) / (other.turn_rad / other.scale);
                if (!is_other(other)) continue;
                EXPECT_GT(std::abs(read - 1.0), 0.05) << chosen.name;
            }
            // At any place, every reading of the chosen kind is taken for it.
            const JointAngles read{own.turn_rad / own.scale, 0.0};
            for (const double turned : {-2.0, 0.0, 2.0})
                EXPECT_EQ(links_of(known, read, {turned, turned}), LinksOf::chosen_kind);
        }
    }
}

TEST(HomingPlan, StretchesBothArmsOfEveryProfileOrRetractsThem) {
    for (const DeviceProfile& profile : device_profiles()) {
        const HomingPlan plan = homing_plan(profile);
        const auto home = forward(profile.geometry, plan.home);
        ASSERT_TRUE(home.has_value()) << profile.name;
        EXPECT_GT(plan.arm_m * norm(plan.check - plan.home), 0.05) << profile.name;
        if (profile.check.place != StopPlace::towards) continue;
        // The links of both arms are in one line, or nearly so: the tip is as far out as it goes.
        const Geometry& arms = profile.geometry;
        const double reach_m = arms.proximal_m + arms.distal_m;
        const Position elbow{arms.proximal_m * std::cos(plan.check.x),
                             arms.proximal_m * std::sin(plan.check.x)};
        const double distal_x_m = 0.5 * arms.base_m - elbow.x;
        const double tip_y_m =
            elbow.y + std::sqrt(arms.distal_m * arms.distal_m - distal_x_m * distal_x_m);
        EXPECT_GT(std::hypot(0.5 * arms.base_m, tip_y_m), 0.97 * reach_m) << profile.name;
    }
}

TEST(DriftWatch, NeedsATimeBeyondAStop) {
    const JointAngles past_home = retracted - 0.1 * (extended - retracted);
    const JointAngles past_check = extended + 0.1 * (extended - retracted);
    for (const JointAngles& past : {past_home, past_check}) {
        DriftWatch watch(gen31);
        for (int k = 0; k < 290; ++k) EXPECT_FALSE(watch.step(past, tick_s));
        EXPECT_FALSE(watch.step(retracted, tick_s));
        bool has_drifted = false;
        for (int k = 0; k < 310; ++k) has_drifted = watch.step(past, tick_s);
        EXPECT_TRUE(has_drifted);
        EXPECT_TRUE(watch.step(retracted, tick_s));
    }
}

TEST(DriftWatch, IsQuietOverTheWholeDrawingArea) {
    const DeviceProfile& profile = default_profile();
    DriftWatch watch(gen31);
    for (int x = -58; x <= 58; ++x) {
        for (int y = -42; y <= 42; ++y) {
            const Position p_D = device_from_picture(profile, {x * 1e-3, y * 1e-3});
            EXPECT_FALSE(watch.step(inverse(profile.geometry, p_D).value(), 1.0));
        }
    }
}

}  // namespace
}  // namespace touchline
