#include "haptics/servo/recorder.h"

#include "haptics/servo/servo_loop.h"
#include "tests/haptics/servo/rigs.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

TickRecord at(double time_s) {
    TickRecord tick;
    tick.time_s = time_s;
    return tick;
}

TEST(Recorder, KeepsWhatATickWas) {
    PlacedDevice device({0.0, 0.01});
    ServoExchange exchange;
    exchange.feel(line_scene(0.0, 7));
    ServoCommands commands;
    commands.contact.stiffness_N_per_m = 321.0;
    exchange.set(commands);
    Recorder recorder(4);
    ServoLoop loop(device, default_profile(), 1e-3, exchange, recorder);
    loop.tick(0.5, 3);
    const auto ticks = recorder.ticks();
    ASSERT_EQ(ticks.size(), 1U);
    const TickRecord& tick = ticks[0];
    EXPECT_EQ(tick.input.now_s, 0.5);
    EXPECT_EQ(tick.input.missed_ticks, 3U);
    EXPECT_EQ(tick.input.angles, device.angles);
    EXPECT_EQ(tick.input.commands, commands);
    EXPECT_EQ(tick.input.scene, nullptr);
    EXPECT_EQ(tick.wanted_version, 7U);
    EXPECT_FALSE(tick.is_refused);
    const HandState& hand = exchange.report().hand;
    EXPECT_EQ(tick.time_s, hand.time_s);
    EXPECT_EQ(tick.p_WH, hand.p_WH);
    EXPECT_EQ(tick.p_WP, hand.p_WP);
    EXPECT_EQ(tick.level, hand.level);
    EXPECT_EQ(tick.stiffness_N_per_m, hand.stiffness_N_per_m);
    EXPECT_EQ(tick.map_version, 7U);
    EXPECT_EQ(tick.force_state, ForceState::armed);
}

TEST(Recorder, KeepsTheNewestOldestFirst) {
    Recorder recorder(3);
    for (int i = 0; i < 8; ++i) recorder.push(at(i));
    const auto ticks = recorder.ticks();
    ASSERT_EQ(ticks.size(), 3U);
    EXPECT_EQ(ticks[0].time_s, 5.0);
    EXPECT_EQ(ticks[2].time_s, 7.0);
}

TEST(Recorder, WhatIsWipedIsOverwrittenWhereItLay) {
    PlacedDevice device({0.0123, 0.0456});
    ServoExchange exchange;
    Recorder recorder(8000);
    ServoLoop loop(device, default_profile(), 1e-3, exchange, recorder);
    for (int i = 0; i < 6000; ++i) loop.tick(1e-3 * i, 0);
    const TickRecord* const place = recorder.newest();  // in the recorder's own memory
    ASSERT_NE(place->p_WH.x, 0.0);
    recorder.hold();
    loop.tick(6.0, 0);
    ASSERT_TRUE(recorder.is_held());
    recorder.wipe();
    EXPECT_EQ(place->p_WH, Position{});
    EXPECT_EQ(place->input.angles, TickRecord{}.input.angles);
    EXPECT_EQ(recorder.newest(), nullptr);
    EXPECT_TRUE(recorder.ticks().empty());
    EXPECT_FALSE(recorder.start().has_value());
    recorder.release();
    loop.tick(6.001, 0);
    loop.tick(6.002, 0);
    EXPECT_FALSE(recorder.ticks().empty()) << "and it records again";
}

TEST(Recorder, WithoutRoomKeepsNothing) {
    Recorder recorder;
    recorder.push(at(1.0));
    EXPECT_TRUE(recorder.ticks().empty());
    EXPECT_FALSE(recorder.start().has_value());
}

TEST(Recorder, KnowsTheStepNoLaterThanFiveThousandTicksAfterTheOldest) {
    Recorder recorder(12'000);
    const ServoStep step(default_profile(), 1e-3);
    for (int i = 0; i < 50'000; ++i) {
        recorder.begin(step);
        recorder.push(at(i));
        if (i % 777 != 0) continue;
        const auto start = recorder.start();
        ASSERT_TRUE(start.has_value());
        ASSERT_LT(start->tick, 5000U);
        const auto first = static_cast<int>(recorder.ticks()[start->tick].time_s);
        ASSERT_EQ(first % 5000, 0);
    }
}

TEST(Recorder, HeldItStaysAsItIsAndReleasedItBeginsAnew) {
    Recorder recorder(100);
    const ServoStep step(default_profile(), 1e-3);
    const auto tick = [&](double time_s) {
        recorder.begin(step);
        recorder.push(at(time_s));
    };
    tick(1.0);
    recorder.hold();
    EXPECT_FALSE(recorder.is_held());  // a tick may be under way
    tick(2.0);
    EXPECT_TRUE(recorder.is_held());
    EXPECT_EQ(recorder.ticks().size(), 1U);
    recorder.release();
    tick(3.0);
    tick(4.0);
    EXPECT_FALSE(recorder.is_held());
    ASSERT_EQ(recorder.ticks().size(), 2U);
    EXPECT_EQ(recorder.ticks()[0].time_s, 3.0);
    EXPECT_EQ(recorder.start()->tick, 0U);
}

}  // namespace
}  // namespace touchline
