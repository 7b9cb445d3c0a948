#include "app/force/servo/messages.h"

#include "app/force/servo/black_box.h"
#include "app/force/servo/running_servo.h"
#include "app/force/servo/servo_connection.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

namespace touchline {
namespace {

std::vector<std::byte> some_bytes() {
    return {std::byte{1}, std::byte{2}, std::byte{3}};
}

TEST(SharedRegion, IsNoOtherMemory) {
    EXPECT_FALSE(SharedRegion::open(sealed_copy(some_bytes()).value()).has_value());
    EXPECT_FALSE(SharedRegion::open(memory_of_size(100).value()).has_value());
    EXPECT_FALSE(SharedRegion::open(Descriptor{}).has_value());
}

TEST(SharedRegion, IsOneMemoryOnBothSides) {
    const auto kiosk = SharedRegion::create().value();
    const auto servo = SharedRegion::open(kiosk.descriptor()).value();
    kiosk.channel().kiosk_beats = 7;
    EXPECT_EQ(servo.channel().kiosk_beats, 7U);
    ServoReport report;
    report.hand.ticks = 12;
    servo.channel().reports.write(report);
    ASSERT_TRUE(kiosk.channel().reports.update());
    EXPECT_EQ(kiosk.channel().reports.value().hand.ticks, 12U);
}

TEST(Messages, ArriveWholeWithTheirDescriptor) {
    const auto [kiosk, servo] = socket_pair().value();
    Arrival arrival;
    EXPECT_EQ(receive(servo, arrival), ReceiveStatus::none);
    const Descriptor memory = sealed_copy(some_bytes()).value();
    ASSERT_TRUE(send(kiosk, message_of(MessageKind::scene, "a line\nof two"), &memory));
    ASSERT_EQ(receive(servo, arrival), ReceiveStatus::received);
    EXPECT_EQ(arrival.message.kind, MessageKind::scene);
    EXPECT_EQ(line_of(arrival.message), "a line of two");
    EXPECT_TRUE(map_sealed(arrival.attached, 100).has_value());
    ASSERT_TRUE(send(kiosk, message_of(MessageKind::notice, std::string(1000, 'x'))));
    ASSERT_EQ(receive(servo, arrival), ReceiveStatus::received);
    EXPECT_FALSE(arrival.attached.is_open());
    EXPECT_EQ(line_of(arrival.message), std::string(sizeof Message::line, 'x'));
}

TEST(Messages, ABoardComesWithItsNodeOrNotAtAll) {
    const auto [kiosk, servo] = socket_pair().value();
    const UsbNode node{-1, {0, 1, 0x02, 0x83}, "1-2.3"};
    const Descriptor file = sealed_copy(some_bytes()).value();
    ASSERT_TRUE(send(servo, message_of(node), &file));
    Arrival arrival;
    ASSERT_EQ(receive(kiosk, arrival), ReceiveStatus::received);
    const auto held = held_board_of(arrival);
    ASSERT_TRUE(held.has_value());
    EXPECT_TRUE(held->node.is_open());
    EXPECT_EQ(held->pipes.data_interface, 1);
    EXPECT_EQ(held->pipes.out_endpoint, 0x02);
    EXPECT_EQ(held->bus_path, "1-2.3");
    ASSERT_TRUE(send(servo, message_of(node)));
    ASSERT_EQ(receive(kiosk, arrival), ReceiveStatus::received);
    EXPECT_FALSE(held_board_of(arrival).has_value());
}

TEST(Messages, WhatHomingFoundArrivesAndNothingThatIsOutOfRange) {
    const Calibration found{{0.3, 0.1},           {0.02, -0.01}, 1.19, {true, false, true},
                            {false, true, false}, true,          true, {}};
    Calibration before;
    before.torque_limit_Nm = 0.156;
    const auto kept = calibration_of(message_of(found), before);
    ASSERT_TRUE(kept.has_value());
    EXPECT_EQ(kept->offset, JointAngles{});  // holds until the board is set up again
    EXPECT_EQ(kept->stop_off, found.stop_off);
    EXPECT_EQ(kept->scale, found.scale);
    EXPECT_EQ(kept->encoders, found.encoders);
    EXPECT_EQ(kept->motors, found.motors);
    EXPECT_TRUE(kept->is_measured);
    EXPECT_TRUE(kept->has_all_counts);
    EXPECT_EQ(kept->torque_limit_Nm, 0.156);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {nan, 0.0, 2.0, -1.0}) {
        Message message = message_of(found);
        message.home.scale = bad;
        EXPECT_FALSE(calibration_of(message, before).has_value()) << bad;
        message = message_of(found);
        message.home.stop_off_2 = bad == 0.0 ? 0.2 : bad;
        EXPECT_FALSE(calibration_of(message, before).has_value()) << bad;
    }
    for (std::uint16_t HomeFound::*plugs : {&HomeFound::encoders, &HomeFound::motors}) {
        Message message = message_of(found);
        message.home.*plugs = 8;
        EXPECT_FALSE(calibration_of(message, before).has_value());
    }
}

TEST(Messages, NonsenseCountsAsGone) {
    Message unknown = message_of(MessageKind::notice);
    unknown.kind = static_cast<MessageKind>(77);
    Message too_long = message_of(MessageKind::notice);
    too_long.line_bytes = sizeof Message::line + 1;
    for (const Message& message : {unknown, too_long}) {
        const auto [kiosk, servo] = socket_pair().value();
        ASSERT_TRUE(send(kiosk, message));
        Arrival arrival;
        EXPECT_EQ(receive(servo, arrival), ReceiveStatus::gone);
    }
    for (const std::size_t size : {std::size_t{1}, sizeof(Message) - 1, sizeof(Message) + 1}) {
        const auto [kiosk, servo] = socket_pair().value();
        const std::string bytes(size, '\0');
        ASSERT_EQ(::send(kiosk.number(), bytes.data(), size, 0), static_cast<ssize_t>(size));
        Arrival arrival;
        EXPECT_EQ(receive(servo, arrival), ReceiveStatus::gone);
    }
    auto ends = socket_pair().value();
    ends.first = Descriptor{};
    Arrival arrival;
    EXPECT_EQ(receive(ends.second, arrival), ReceiveStatus::gone);
    EXPECT_FALSE(send(ends.second, message_of(MessageKind::failed)));
}

TEST(Messages, OrdersOutOfRangeBuildNothing) {
    TactileMap map;
    map.outlines.emplace_back().points = {{-0.05, 0.0}, {0.0, 0.001}, {0.05, 0.0}};
    EXPECT_TRUE(build_scene(map, SceneOrder{}).has_value());
    EXPECT_TRUE(build_scene(map, SceneOrder{1e-4, 0.001, 1, 0}).has_value());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {nan, -1.0, 1.0, std::numeric_limits<double>::infinity()}) {
        EXPECT_FALSE(build_scene(map, SceneOrder{bad, 0.0, 0, 0}).has_value());
        EXPECT_FALSE(build_scene(map, SceneOrder{1e-4, bad, 0, 0}).has_value());
    }
    EXPECT_FALSE(build_scene(map, SceneOrder{1e-4, 0.0, 2, 0}).has_value());
}

TEST(ServoConnection, SaysThatNothingIsKeptWhereNoServoRuns) {
    ServoConnection line;
    line.ask_recorder(MessageKind::hold);
    line.ask_recorder(MessageKind::forget);
    EXPECT_EQ(line.take_notice(), "");
    line.ask_recorder(MessageKind::keep);
    EXPECT_EQ(line.take_notice().find(recording_not_kept), 0U);
}

TEST(Messages, APlaceComesBackTheSameOrNotAtAll) {
    const HandlePlace place{{0.25, -1.0 / 3.0}, 77};
    const auto back = place_of(message_of(place)).value();
    EXPECT_EQ(back.offset, place.offset);
    EXPECT_EQ(back.slept_ns, place.slept_ns);
    EXPECT_FALSE(place_of(message_of(MessageKind::done)).has_value());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(place_of(message_of(HandlePlace{{nan, 0.0}, 77})).has_value());
    EXPECT_TRUE(place_of(message_of(HandlePlace{{}, -150})).has_value())
        << "two clocks, read one after the other, of a machine that never slept";
}

TEST(Restart, WaitsLongerWithEveryDeathAndStartsOverAfterAGoodMinute) {
    Restart restart;
    for (const double wait_s : {0.5, 1.0, 2.0, 4.0, 8.0, 8.0})
        EXPECT_EQ(restart.wait_s(3.0), wait_s);
    EXPECT_EQ(restart.wait_s(60.0), 0.5);
    EXPECT_EQ(restart.wait_s(0.0), 1.0);
}

}  // namespace
}  // namespace touchline
