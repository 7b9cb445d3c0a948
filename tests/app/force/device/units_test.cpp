// Tests units as found in the field: each becomes ready with the tip within a millimetre, or hears
// what does not fit.
#include "config/types/angle.h"
#include "tests/app/force/device/device_visit.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double counts_4096 = 4096.0 / 4880.0 - 1.0;

/// A unit, and the kind that people say it is.
struct FieldUnit {
    std::string name;
    std::string kind = "2diy-gen3.1";
    JointAngles stop;             // for its bent arms, degrees
    double scale_error = 0.0;     // relative: surplus of counts
    bool has_all_counts = false;  // firmware that does not halve the counts
    bool do_counts_step_back = false;
    Plugs motors{}, encoders{};
};

void PrintTo(const FieldUnit& unit, std::ostream* out) {
    *out << unit.name;
}

std::vector<FieldUnit> field_units() {
    const Plugs second{false, false, true}, both{false, true, true};
    return {
        {"gen31_168_12", "2diy-gen3.1", {168.0, 12.0}},
        {"gen31_166_11", "2diy-gen3.1", {166.58, 11.11}},
        {"gen31_172_8", "2diy-gen3.1-172", {172.0, 8.0}},
        {"gen31_180_0", "2diy-gen3.1-180", {180.0, 0.0}},
        {"gen31_168_12_of_4096", "2diy-gen3.1", {168.0, 12.0}, counts_4096},
        {"gen31_166_11_of_4096", "2diy-gen3.1", {166.58, 11.11}, counts_4096},
        {"gen31_172_8_of_4096", "2diy-gen3.1-172", {172.0, 8.0}, counts_4096},
        {"gen31_180_0_of_4096", "2diy-gen3.1-180", {180.0, 0.0}, counts_4096},
        {"gen31_unhalved", "2diy-gen3.1", {168.0, 12.0}, 0.0, true},
        {"gen31_unhalved_4096", "2diy-gen3.1", {168.0, 12.0}, counts_4096, true},
        {"gen31_double", "2diy-gen3.1", {168.0, 12.0}, 1.0},
        {"gen31_steps_back", "2diy-gen3.1", {168.0, 12.0}, 0.0, false, true},
        {"gen31_clockwise", "2diy-gen3.1", {168.0, 12.0}, 0.0, false, false, both, both},
        {"gen31_motors_clockwise", "2diy-gen3.1", {168.0, 12.0}, 0.0, false, false, both, {}},
        {"gen31_180_0_encoders_clockwise",
         "2diy-gen3.1-180",
         {180.0, 0.0},
         0.0,
         false,
         false,
         {},
         both},
        {"gen3", "2diy-gen3", {168.0, 12.0}},
        {"gen2", "2diy-gen2", {241.0, -61.0}},
        {"gen2_240", "2diy-gen2-240", {240.0, -60.0}},
        {"haplet", "haplet", {180.0, 0.0}},
        {"haplet_second_reversed", "haplet", {180.0, 0.0}, 0.0, false, false, second, second},
    };
}

BoardTruth truth_of(const FieldUnit& unit) {
    BoardTruth truth;
    truth.profile = find_profile(unit.kind).value();
    const JointAngles stop = radians(1.0) * unit.stop;
    const bool is_home_stretched = truth.profile.home_place == StopPlace::towards;
    (is_home_stretched ? truth.profile.check.angles : truth.profile.home) = stop;
    truth.hand = stiff_arm;  // leans on the stop, so that friction leaves it a tenth off
    truth.type = unit.kind == "haplet" ? BoardType::due : BoardType::m0;
    truth.firmware.has_all_counts = unit.has_all_counts;
    truth.scale_error = {unit.scale_error, unit.scale_error};
    truth.do_counts_step_back = unit.do_counts_step_back;
    truth.motors = unit.motors;
    truth.encoders = unit.encoders;
    return truth;
}

/// Returns the worst error over places all over the drawing area.
double worst_tip_off_m(DeviceVisit& visit) {
    const Area& area = visit.rig.board.truth().profile.area;
    double worst_m = 0.0;
    visit.rig.board.grip(visit.rig.board.truth().hand);
    for (const double x : {-0.45, 0.0, 0.45}) {
        for (const double y : {-0.45, 0.0, 0.45}) {
            visit.person->go({x * area.width_m, y * area.height_m}, visit.rig.time.now_s);
            visit.rig.tick_for(1.2, {});
            worst_m = std::max(worst_m, visit.tip_off_m());
        }
    }
    return worst_m;
}

class Unit : public testing::TestWithParam<FieldUnit> {};

TEST_P(Unit, BecomesReadyWithTheTipWithinAMillimetre) {
    const FieldUnit& unit = GetParam();
    const DeviceProfile kind = find_profile(unit.kind).value();
    DeviceVisit visit(truth_of(unit), {}, &kind);
    visit.end_s = 300.0;
    ASSERT_TRUE(visit.rig.driver->open().has_value());
    const auto ready = make_ready(visit.procedure(), {});
    ASSERT_TRUE(ready.has_value()) << visit.person->heard.back();
    EXPECT_EQ(ready->has_all_counts, unit.has_all_counts);
    const double worst_m = worst_tip_off_m(visit);
    EXPECT_LT(worst_m, 1e-3);
    // A second time as a known unit, as when it is plugged in again.
    visit.rig.connect({}, *ready, &kind);
    visit.person->go({}, visit.rig.time.now_s);
    visit.end_s = visit.rig.time.now_s + 120.0;
    ASSERT_TRUE(visit.rig.driver->open().has_value());
    ASSERT_TRUE(make_ready(visit.procedure(), *ready).has_value()) << visit.person->heard.back();
    EXPECT_LT(worst_tip_off_m(visit), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Field, Unit, testing::ValuesIn(field_units()),
                         [](const auto& made) { return made.param.name; });

/// A unit that is taken for another kind.
struct Taken {
    FieldUnit unit;
    std::string kind;
};

void PrintTo(const Taken& taken, std::ostream* out) {
    *out << taken.unit.name << " as " << taken.kind;
}

std::vector<Taken> wrongly_taken() {
    std::vector<Taken> all;
    for (const FieldUnit& unit : field_units())
        for (const DeviceProfile& kind : device_profiles())
            if (kind.name != unit.kind) all.push_back({unit, std::string(kind.name)});
    return all;
}

/// The two gen 2 differ by a degree at the stop, which cannot be read while their arms are
/// stretched.
double allowed_m(const Taken& taken) {
    return taken.unit.kind.starts_with("2diy-gen2") ? 1.25e-3 : 1e-3;
}

class WrongKind : public testing::TestWithParam<Taken> {};

/// Two stops cannot tell a stop in another place from an encoder that counts differently.
TEST_P(WrongKind, IsSaidOrTheTipIsWithinAMillimetreAllTheSame) {
    const DeviceProfile kind = find_profile(GetParam().kind).value();
    DeviceVisit visit(truth_of(GetParam().unit), {}, &kind);
    if (!visit.rig.driver->open()) return;  // this kind has no such board
    Procedure procedure = visit.procedure();
    const auto is_said = [&] {
        return visit.was_heard("of another kind") ||
               visit.was_heard("not of the kind that was chosen") ||
               visit.was_heard("has not moved");
    };
    procedure.goes_on = [&] { return visit.rig.time.now_s < 250.0 && !is_said(); };
    if (make_ready(procedure, {})) {
        EXPECT_LT(worst_tip_off_m(visit), allowed_m(GetParam()));
        return;
    }
    EXPECT_TRUE(is_said()) << visit.person->heard.back();
    for (const TorqueChange& change : visit.rig.board.told_torques())
        EXPECT_EQ(change.torques, JointTorques{});
}

INSTANTIATE_TEST_SUITE_P(Every, WrongKind, testing::ValuesIn(wrongly_taken()));

class HighFriction : public testing::TestWithParam<const char*> {};

TEST_P(HighFriction, LeavesTheMotorsToBeTried) {
    const DeviceProfile kind = find_profile(GetParam()).value();
    const bool is_home_stretched = kind.home_place == StopPlace::towards;
    const JointAngles bent = is_home_stretched ? kind.check.angles : kind.home;
    BoardTruth truth = truth_of({"", GetParam(), degrees(1.0) * bent});
    truth.profile.mechanics.coulomb_N = 0.25;
    DeviceVisit visit(truth);
    visit.end_s = 300.0;
    ASSERT_TRUE(visit.rig.driver->open().has_value());
    const auto ready = make_ready(visit.procedure(), {});
    EXPECT_TRUE(ready.has_value()) << visit.person->heard.back();
}

INSTANTIATE_TEST_SUITE_P(Kinds, HighFriction,
                         testing::Values("2diy-gen3.1", "2diy-gen3.1-172", "2diy-gen3.1-180",
                                         "2diy-gen3", "2diy-gen2", "2diy-gen2-240", "haplet"));

}  // namespace
}  // namespace touchline
