// What the service says, in the words of its maker's pages and of a frame that somebody recorded
// (haptics/device/inverse3/README.md).
#include "haptics/device/inverse3/inverse3_frames.h"

#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

const std::string recorded_frame =
    R"({"inverse3":[{"device_id":"04EA","state":{"angular_position":{"a0":-30.927332,"a1":53.878685,)"
    R"("a2":-6.642623},"body_orientation":{"w":0.69885254,"x":0.0014648438,"y":0.715271,)"
    R"("z":0.0024414062},"control_mode":"idle","current_cursor_force":{"x":0,"y":0,"z":0},)"
    R"("cursor_position":{"x":0.10428079,"y":-0.03648221,"z":-0.06100729},)"
    R"("cursor_velocity":{"x":0,"y":0.5,"z":-1e-2},"mode":"idle",)"
    R"("transform":{"position":{"x":0,"y":0,"z":0},"rotation":{"w":1,"x":0,"y":0,"z":0},)"
    R"("scale":{"x":1,"y":1,"z":1}}},"status":{"calibrated":true,"in_use":false,)"
    R"("power_supply":true,"ready":false,"started":true}}],"wireless_verse_grip":[]})";

std::string one_arm(const std::string& inside) {
    return R"({"inverse3":[{"device_id":"04EA")" + inside + "}]}";
}

std::string with_place(const std::string& x) {
    return one_arm(R"(,"state":{"cursor_position":{"x":)" + x + R"(,"y":0,"z":0}})");
}

TEST(Inverse3Frames, ARecordedFrameIsReadWhole) {
    const auto frame = read_frame(recorded_frame);
    ASSERT_TRUE(frame);
    ASSERT_EQ(frame->arm_count, 1U);
    EXPECT_FALSE(frame->has_session);
    const ArmInFrame& arm = frame->arms[0];
    EXPECT_EQ(arm.name.text(), "04EA");
    EXPECT_EQ(arm.place_m, (Space{0.10428079, -0.03648221, -0.06100729}));
    EXPECT_EQ(arm.velocity_m_per_s, (Space{0.0, 0.5, -0.01}));
    EXPECT_EQ(arm.applied_N, Space{});
    EXPECT_EQ(arm.status.is_calibrated, true);
    EXPECT_EQ(arm.status.has_power, true);
    EXPECT_EQ(arm.status.is_ready, false);
    EXPECT_FALSE(arm.has_other_axes);
    EXPECT_FALSE(arm.is_other_kind);
}

TEST(Inverse3Frames, TheListOfDevicesTellsKindsAndSessions) {
    const auto frame = read_frame(
        R"({"session_id":7,"inverse3":[{"device_id":"049D","config":{"type":"minverse"}},)"
        R"({"device_id":"04EA","config":{"type":"inverse3x"}}]})");
    ASSERT_TRUE(frame);
    EXPECT_TRUE(frame->has_session);
    ASSERT_EQ(frame->arm_count, 2U);
    EXPECT_TRUE(frame->arms[0].is_other_kind);
    EXPECT_FALSE(frame->arms[1].is_other_kind);
    EXPECT_EQ(frame->arms[1].place_m, std::nullopt);
    EXPECT_EQ(frame->find(*ArmName::of("04EA")), &frame->arms[1]);
    EXPECT_EQ(frame->find(*ArmName::of("04EB")), nullptr);
}

TEST(Inverse3Frames, WhatIsNotSaidIsNotKnown) {
    const auto frame = read_frame(one_arm(R"(,"state":{},"status":{})"));
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->arms[0].place_m, std::nullopt);
    EXPECT_EQ(frame->arms[0].applied_N, std::nullopt);
    EXPECT_EQ(frame->arms[0].status.is_ready, std::nullopt);
}

TEST(Inverse3Frames, AxesThatAreNotTheDevicesOwnAreSeen) {
    const auto has_other = [](const std::string& inside) {
        return read_frame(one_arm(inside)).value().arms[0].has_other_axes;
    };
    EXPECT_TRUE(has_other(R"(,"config":{"basis":{"permutation":"XZY"}})"));
    EXPECT_FALSE(has_other(R"(,"config":{"basis":{"permutation":"XYZ"}})"));
    EXPECT_TRUE(has_other(R"(,"config":{"mount":{"position":{"x":0.1,"y":0,"z":0}}})"));
    EXPECT_TRUE(has_other(R"(,"config":{"mount":{"rotation":{"w":0.707,"x":0,"y":0,"z":0.707}}})"));
    EXPECT_TRUE(has_other(R"(,"state":{"transform":{"scale":{"x":2,"y":2,"z":2}}})"));
    EXPECT_TRUE(has_other(R"(,"state":{"transform":{"position":{"z":-0.01}}})"));
    EXPECT_FALSE(has_other(R"(,"state":{"transform":{"rotation":{"w":1,"x":0},"scale":{"x":1}}})"));
}

TEST(Inverse3Frames, WhatIsMalformedIsNoFrame) {
    for (const std::string& text :
         {std::string(), std::string("null"), std::string("[]"), std::string("{}")}) {
        const auto frame = read_frame(text);
        EXPECT_TRUE(!frame || frame->arm_count == 0) << text;
    }
    EXPECT_FALSE(read_frame(recorded_frame + "}"));
    EXPECT_FALSE(read_frame(R"({"inverse3":[{"state":{}}]})"));                          // no name
    EXPECT_FALSE(read_frame(R"({"inverse3":[{"device_id":"a\"b"}]})"));                  // no name
    EXPECT_FALSE(read_frame(R"({"inverse3":[{"device_id":"a"},{"device_id":"a"}]})"));   // twice
    EXPECT_FALSE(read_frame(one_arm(R"(,"state":{"cursor_position":{"x":0,"y":0}})")));  // half
    EXPECT_FALSE(read_frame(with_place("1.5")));
    EXPECT_FALSE(read_frame(with_place("1e999")));
    EXPECT_FALSE(read_frame(with_place("NaN")));
    EXPECT_FALSE(read_frame(with_place("-")));
    EXPECT_TRUE(read_frame(with_place("-1")));
    EXPECT_FALSE(read_frame(one_arm(R"(,"state":{"cursor_velocity":{"x":21,"y":0,"z":0}})")));
}

TEST(Inverse3Frames, SizesAreBounded) {
    EXPECT_FALSE(read_frame(recorded_frame + std::string(longest_frame_bytes, ' ')));
    EXPECT_FALSE(read_frame(std::string(1000, '[')));
    EXPECT_FALSE(read_frame(R"({"a":)" + std::string(20, '[') + std::string(20, ']') + "}"));
    std::string many = R"({"inverse3":[)";
    for (std::size_t i = 0; i <= ServiceFrame::most_arms; ++i)
        many += fmt::format(R"({}{{"device_id":"{}"}})", i == 0 ? "" : ",", i);
    EXPECT_FALSE(read_frame(many + "]}"));
}

TEST(Inverse3Frames, EveryBeginningOfAFrameIsRefused) {
    for (std::size_t size = 0; size < recorded_frame.size(); ++size)
        EXPECT_FALSE(read_frame(recorded_frame.substr(0, size))) << size;
}

RC_GTEST_PROP(Inverse3Frames, AnyBytesInAFrameGiveFiniteNumbersOrNone, ()) {
    std::string text = recorded_frame;
    const auto changes = *rc::gen::container<std::vector<std::pair<std::size_t, char>>>(
        rc::gen::pair(rc::gen::inRange<std::size_t>(0, text.size()), rc::gen::arbitrary<char>()));
    for (const auto& [at, letter] : changes) text[at] = letter;
    const auto frame = read_frame(text);
    if (!frame) return;
    for (std::size_t i = 0; i < frame->arm_count; ++i) {
        const ArmInFrame& arm = frame->arms[i];
        RC_ASSERT(!arm.place_m || (is_finite(*arm.place_m) && std::abs(arm.place_m->x) <= 1.0));
        RC_ASSERT(!arm.velocity_m_per_s || is_finite(*arm.velocity_m_per_s));
    }
}

TEST(Inverse3Frames, CommandsAreInTheWordsOfTheServicesVersion) {
    const ArmName name = ArmName::of("049D").value();
    EXPECT_EQ(force_command(name, {0.5, -1.25, 0.0}, true).text(),
              R"({"inverse3":[{"device_id":"049D","commands":{"set_cursor_force":)"
              R"({"vector":{"x":0.5000,"y":-1.2500,"z":0.0000}}}}]})");
    EXPECT_EQ(force_command(name, {}, false).text(),
              R"({"inverse3":[{"device_id":"049D","commands":{"set_cursor_force":)"
              R"({"values":{"x":0.0000,"y":0.0000,"z":0.0000}}}}]})");
    EXPECT_EQ(inventory_request().text(), R"({"session":{"force_render_full_state":{}}})");
}

TEST(Inverse3Frames, AForceThatIsNotFiniteIsZeroOnAllAxes) {
    const ArmName name = ArmName::of(std::string(ArmName::longest, 'F')).value();
    const std::string_view zero = R"({"x":0.0000,"y":0.0000,"z":0.0000}}}}]})";
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double bad : {infinite, -infinite, std::nan(""), 1e30}) {
        EXPECT_TRUE(force_command(name, {bad, 1.0, 0.0}, true).text().ends_with(zero));
        EXPECT_TRUE(force_command(name, {1.0, bad, 0.0}, true).text().ends_with(zero));
        EXPECT_TRUE(force_command(name, {0.0, 1.0, bad}, true).text().ends_with(zero));
    }
    EXPECT_TRUE(force_command(name, {-100.0, -100.0, -100.0}, true).text().ends_with("}}}}]}"));
}

TEST(Inverse3Frames, NamesArePlain) {
    EXPECT_FALSE(ArmName::of(""));
    EXPECT_FALSE(ArmName::of("a b"));
    EXPECT_FALSE(ArmName::of("a\""));
    EXPECT_FALSE(ArmName::of(std::string(ArmName::longest + 1, 'a')));
    EXPECT_EQ(ArmName::of("0x4A_b-C").value().text(), "0x4A_b-C");
}

}  // namespace
}  // namespace touchline
