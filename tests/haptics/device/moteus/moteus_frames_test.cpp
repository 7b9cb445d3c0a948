// The bytes of the maker's protocol, and what is made of bytes that are not of it.
#include "haptics/device/moteus/moteus_frames.h"

#include "haptics/device/moteus/fdcanusb_link.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

std::string text_of(const CanFrame& frame) {
    const FdcanusbLine line(frame);
    return {line.bytes().begin(), line.bytes().end()};
}

CanFrame answer_with(std::vector<std::uint8_t> bytes) {
    CanFrame frame;
    frame.id = 0x109;
    frame.size = bytes.size();
    std::ranges::copy(bytes, frame.data.begin());
    return frame;
}

void put_float(std::vector<std::uint8_t>& bytes, float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (unsigned shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<std::uint8_t>(bits >> shift));
}

std::vector<std::uint8_t> status_bytes(float turns, float torque_Nm, float watchdog) {
    std::vector<std::uint8_t> bytes{0x21, 0x00, 10, 0x2d, 0x01};
    put_float(bytes, turns);
    bytes.insert(bytes.end(), {0x20, 4, 0x0c, 1, 48, 31, 0, 0x2d, 0x22});
    put_float(bytes, torque_Nm);
    bytes.insert(bytes.end(), {0x2d, 0x27});
    put_float(bytes, watchdog);
    return bytes;
}

TEST(MoteusFrames, AStopIsTheModeAloneAndAsksForTheStatus) {
    EXPECT_EQ(text_of(moteus_stop({1, 9})),
              "can send 8901 010000"  // write one int8 at 0: stopped
              "1100"                  // read one int8 at 0: mode
              "1d01"                  // one float at 1: position
              "10040c"                // four int8 at 12: home, voltage, temperature, fault
              "1d22"                  // one float: torque
              "1d27"                  // one float: watchdog
              "5050\n");              // up to a length that CAN-FD has
}

TEST(MoteusFrames, ATorqueIsPositionModeWithEveryGainScaledToNothing) {
    EXPECT_EQ(text_of(moteus_torque({2, 1}, -0.5, 0.02)),
              "can send 8102 01000a"  // position mode
              "02208000"              // position: as it is; velocity 0
              "0d22000000bf"          // torque -0.5
              "02230000"              // both gains to 0
              "0d250000003f"          // never more than 0.5
              "0d270ad7a33c"          // watchdog 0.02
              "012b00"                // integral to 0
              "012d01"                // whatever bounds are set
              "11001d0110040c1d221d27"
              "5050\n");
}

TEST(MoteusFrames, ATorqueThatIsNotFiniteIsZero) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()})
        EXPECT_EQ(text_of(moteus_torque({1, 1}, bad, 0.02)),
                  text_of(moteus_torque({1, 1}, 0.0, 0.02)));
}

TEST(MoteusFrames, TheConsoleIsWrittenAndPolledAsTunnelledBytes) {
    EXPECT_EQ(text_of(moteus_console({1, 2}, "tel\n")), "can send 8201 40010474656c0a\n");
    EXPECT_EQ(text_of(moteus_console_poll({1, 2})), "can send 8201 420130\n");
}

TEST(MoteusFrames, AWholeStatusIsRead) {
    const MoteusAnswer answer = moteus_answer(answer_with(status_bytes(-0.25F, 0.5F, 0.02F)));
    ASSERT_EQ(answer.kind, MoteusAnswer::Kind::status);
    EXPECT_EQ(answer.from.controller, 1);
    EXPECT_EQ(answer.from.question, 9);
    EXPECT_EQ(answer.status.mode, 10);
    EXPECT_EQ(answer.status.turns, -0.25);
    EXPECT_EQ(answer.status.home, 1);
    EXPECT_EQ(answer.status.fault, 0);
    EXPECT_TRUE(is_read_back(0.5, answer.status.torque_Nm));
    EXPECT_TRUE(is_read_back(0.02, answer.status.watchdog_s));
}

TEST(MoteusFrames, WhatIsNotWholeOrNotFiniteIsWrong) {
    const auto kind = [](std::vector<std::uint8_t> bytes) {
        return moteus_answer(answer_with(std::move(bytes))).kind;
    };
    const auto whole = status_bytes(0.1F, 0.0F, 0.02F);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_EQ(kind({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}),
                  MoteusAnswer::Kind::wrong)
            << size;
    }
    const float bad = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(kind(status_bytes(bad, 0.0F, 0.02F)), MoteusAnswer::Kind::wrong);
    EXPECT_EQ(kind(status_bytes(0.0F, bad, 0.02F)), MoteusAnswer::Kind::wrong);
    EXPECT_EQ(kind(status_bytes(0.0F, 0.0F, bad)), MoteusAnswer::Kind::wrong);
    // The example of the maker's page, which answers another question.
    EXPECT_EQ(kind({0x24, 0x04, 0x00, 0x0a, 0x00, 0x50, 0x00, 0x00, 0x01, 0x70, 0xff, 0x23, 0x0d,
                    0x18, 0x14, 0x00}),
              MoteusAnswer::Kind::wrong);
    EXPECT_EQ(kind({0x30, 0x2d, 0x01}), MoteusAnswer::Kind::unknown_register);
}

RC_GTEST_PROP(MoteusFrames, AnyBytesAreReadWithoutHarm, ()) {
    auto bytes = *rc::gen::arbitrary<std::vector<std::uint8_t>>();
    bytes.resize(std::min<std::size_t>(bytes.size(), 64));
    const MoteusAnswer answer = moteus_answer(answer_with(bytes));
    if (answer.kind == MoteusAnswer::Kind::status) RC_ASSERT(std::isfinite(answer.status.turns));
    RC_ASSERT(answer.text_size <= answer.text.size());
}

TEST(FdcanusbLines, AReceivedFrameIsReadWithOrWithoutFlags) {
    for (const char* line : {"rcv 100 2404ff", "rcv 100 2404FF E B F t1234 f-1"}) {
        const auto frame = frame_of(line);
        ASSERT_TRUE(frame.has_value()) << line;
        EXPECT_EQ(frame->id, 0x100U);
        ASSERT_EQ(frame->size, 3U);
        EXPECT_EQ(frame->data[2], 0xff);
    }
}

TEST(FdcanusbLines, OtherLinesAreNoFrames) {
    const std::string long_data(130, '0');
    for (const std::string& line :
         {std::string("OK"), std::string("ERR bad id"), std::string("rcv"),
          std::string("rcv 100 2"), std::string("rcv 100 2x"), std::string("rcv -1 20"),
          std::string("rcv 20000000 20"), std::string("rcv  20"), "rcv 100 " + long_data})
        EXPECT_FALSE(frame_of(line).has_value()) << line;
}

RC_GTEST_PROP(FdcanusbLines, AFrameComesBackAsItWas, ()) {
    CanFrame frame;
    frame.id = *rc::gen::inRange<std::uint32_t>(0, 0x1fffffff);
    const auto bytes = *rc::gen::arbitrary<std::vector<std::uint8_t>>();
    frame.size = std::min<std::size_t>(bytes.size(), 64);
    std::copy_n(bytes.begin(), frame.size, frame.data.begin());
    std::string line = text_of(frame).substr(std::string("can send").size());
    line.pop_back();
    const auto back = frame_of("rcv" + line);
    RC_ASSERT(back.has_value());
    RC_ASSERT(back->id == frame.id);
    RC_ASSERT(std::ranges::equal(back->bytes(), frame.bytes()));
}

}  // namespace
}  // namespace touchline
