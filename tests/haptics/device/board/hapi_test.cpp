// The wire protocol against bytes worked out from the firmware by hand.
#include "haptics/device/board/hapi.h"

#include "haptics/device/board/board_frame.h"

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes bytes_of(std::string_view hex) {
    Bytes bytes;
    for (std::size_t i = 0; i < hex.size(); i += 3)
        bytes.push_back(
            static_cast<std::uint8_t>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16)));
    return bytes;
}

Bytes bytes_of(const Command& command) {
    return {command.bytes().begin(), command.bytes().end()};
}

BoardFrame frame_of(std::string_view profile, const Calibration& calibration = {}) {
    return {find_profile(profile).value(), calibration};
}

Bytes set_up_at_home(std::string_view profile) {
    return bytes_of(set_up_command(frame_of(profile).set_up_at_home()));
}

TEST(Hapi, ResetIsTwoZeros) {
    EXPECT_EQ(bytes_of(reset_command()), bytes_of("00 00"));
}

TEST(Hapi, SetUpOfEveryDeviceIsByteForByteThatOfTheMakersPrograms) {
    EXPECT_EQ(set_up_at_home("haplet"),
              bytes_of("01 05 03 00 00 03 00 00 00 00 00 00 34 43 00 00 58 46 00 00 00 00 00 00 58 "
                       "46"));
    EXPECT_EQ(set_up_at_home("2diy-gen2"),
              bytes_of("01 05 03 00 01 03 00 01 00 00 00 00 74 c2 00 00 28 46 00 00 71 43 00 00 28 "
                       "46"));
    EXPECT_EQ(set_up_at_home("2diy-gen3"),
              bytes_of("01 05 03 01 01 03 01 01 00 00 3d 8a a5 42 a0 1a a3 45 c3 75 c2 42 a5 9d a5 "
                       "45"));
    EXPECT_EQ(set_up_at_home("2diy-gen3.1"),
              bytes_of("01 05 03 01 01 03 01 01 00 00 00 00 40 41 00 80 98 45 00 00 28 43 00 80 98 "
                       "45"));
}

TEST(Hapi, SetUpWithAnAnalogInputNamesItsPin) {
    BoardSetUp set_up = frame_of("2diy-gen3.1").set_up_at_home();
    set_up.analog_pin = 56;
    EXPECT_EQ(bytes_of(set_up_command(set_up)),
              bytes_of("01 05 03 01 01 03 01 01 01 38 00 00 00 40 41 00 80 98 45 00 00 28 43 00 80 "
                       "98 45"));
}

TEST(Hapi, WriteIsTenBytesInPortOrder) {
    EXPECT_EQ(bytes_of(write_command({})), bytes_of("02 05 00 00 00 00 00 00 00 00"));
    EXPECT_EQ(bytes_of(write_command({0.05, -0.05})), bytes_of("02 05 cd cc 4c 3d cd cc 4c bd"));
    EXPECT_EQ(bytes_of(write_command({0.123, -0.123})), bytes_of("02 05 6d e7 fb 3d 6d e7 fb bd"));
}

TEST(Hapi, TorqueThatIsNotFiniteMakesBothZero) {
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double bad : {infinite, -infinite, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_EQ(bytes_of(write_command({bad, 0.1})), bytes_of(write_command({})));
        EXPECT_EQ(bytes_of(write_command({0.1, bad})), bytes_of(write_command({})));
    }
}

TEST(Hapi, FirstRepliesAtHomeDecodeToWholeCounts) {
    const Reply gen31 = decode_reply(bytes_of("05 8f 36 3f 41 d2 e6 27 43"));
    ASSERT_EQ(gen31.kind, ReplyKind::angles);
    EXPECT_NEAR(gen31.angles.x, 360.0 * 81.0 / 2440.0, 1e-6);
    EXPECT_NEAR(gen31.angles.y, 360.0 * 1138.0 / 2440.0, 1e-5);
    const Reply gen2 = decode_reply(bytes_of("05 00 c0 73 c2 00 f0 70 43"));
    ASSERT_EQ(gen2.kind, ReplyKind::angles);
    EXPECT_EQ(gen2.angles.x, -60.9375);
    EXPECT_EQ(gen2.angles.y, 240.9375);
}

TEST(Hapi, ReplyIsJudgedByLengthAddressAndValues) {
    const Bytes good = bytes_of("05 8f 36 3f 41 d2 e6 27 43");
    EXPECT_EQ(decode_reply({}).kind, ReplyKind::empty);
    EXPECT_EQ(decode_reply(bytes_of("05")).kind, ReplyKind::unconfigured);
    EXPECT_EQ(decode_reply(bytes_of("03")).kind, ReplyKind::wrong);
    for (std::size_t size = 2; size <= 64; ++size) {
        Bytes packet = good;
        packet.resize(size, 0);
        const auto expected = size == good.size() ? ReplyKind::angles : ReplyKind::wrong;
        EXPECT_EQ(decode_reply(packet).kind, expected) << size;
    }
    for (int address = 0; address < 256; ++address) {
        Bytes packet = good;
        packet[0] = static_cast<std::uint8_t>(address);
        const auto expected = address == board_address ? ReplyKind::angles : ReplyKind::wrong;
        EXPECT_EQ(decode_reply(packet).kind, expected) << address;
    }
    EXPECT_EQ(decode_reply(bytes_of("05 00 00 c0 7f d2 e6 27 43")).kind, ReplyKind::wrong);  // NaN
    EXPECT_EQ(decode_reply(bytes_of("05 8f 36 3f 41 00 00 80 ff")).kind, ReplyKind::wrong);  // -inf
}

TEST(Hapi, ReplyWithAnAnalogInputHasItFirst) {
    const Bytes packet = bytes_of("05 00 00 80 44 8f 36 3f 41 d2 e6 27 43");
    const Reply reply = decode_reply(packet, 1);
    ASSERT_EQ(reply.kind, ReplyKind::angles);
    EXPECT_EQ(reply.analog, 1024.0F);
    EXPECT_NEAR(reply.angles.x, 11.9508, 1e-4);
    EXPECT_EQ(decode_reply(packet).kind, ReplyKind::wrong);
}

TEST(Hapi, WhatCompletesAWriteIsZerosForTheRestThenAZeroWrite) {
    for (std::size_t sent = 1; sent < write_bytes; ++sent) {
        Bytes expected(sent > 1 ? write_bytes - sent : 0, 0);
        const Bytes zero_write = bytes_of("02 05 00 00 00 00 00 00 00 00");
        expected.insert(expected.end(), zero_write.begin(), zero_write.end());
        EXPECT_EQ(bytes_of(completing_command(sent)), expected);
    }
    EXPECT_EQ(bytes_of(flush_command()), Bytes(32, 0));
}

}  // namespace
}  // namespace touchline
