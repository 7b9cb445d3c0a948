#include "app/sound/headphone_switch.h"

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/input.h>
#include <rapidcheck/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

std::vector<std::byte> bytes_of(int type, int code, int value) {
    input_event event{};
    event.type = static_cast<std::uint16_t>(type);
    event.code = static_cast<std::uint16_t>(code);
    event.value = value;
    std::vector<std::byte> bytes(sizeof event);
    std::memcpy(bytes.data(), &event, sizeof event);
    return bytes;
}

std::vector<std::byte> inserted(bool is_in) {
    auto bytes = bytes_of(EV_SW, SW_HEADPHONE_INSERT, is_in ? 1 : 0);
    const auto end = bytes_of(EV_SYN, SYN_REPORT, 0);
    bytes.insert(bytes.end(), end.begin(), end.end());
    return bytes;
}

TEST(SwitchStream, KnowsWhatItWasToldUntilTheSwitchMoves) {
    EXPECT_EQ(SwitchStream().are_in(), std::nullopt);
    SwitchStream stream(false);
    EXPECT_EQ(stream.are_in(), false);
    stream.add(inserted(true));
    EXPECT_EQ(stream.are_in(), true);
    stream.add(inserted(false));
    EXPECT_EQ(stream.are_in(), false);
}

TEST(SwitchStream, PassesOverWhatIsNoHeadphone) {
    SwitchStream stream;
    stream.add(bytes_of(EV_SW, SW_MICROPHONE_INSERT, 1));
    stream.add(bytes_of(EV_SW, SW_LINEOUT_INSERT, 1));
    stream.add(bytes_of(EV_KEY, SW_HEADPHONE_INSERT, 1));
    stream.add(bytes_of(EV_SYN, SYN_REPORT, 0));
    EXPECT_EQ(stream.are_in(), std::nullopt);
    EXPECT_FALSE(stream.is_lost());
}

TEST(SwitchStream, SaysWhenEventsWereLost) {
    SwitchStream stream(true);
    stream.add(bytes_of(EV_SYN, SYN_DROPPED, 0));
    EXPECT_TRUE(stream.is_lost());
}

RC_GTEST_PROP(SwitchStream, HoweverTheBytesAreCutTheLastEventCounts, ()) {
    const auto moves = *rc::gen::nonEmpty(rc::gen::arbitrary<std::vector<bool>>());
    std::vector<std::byte> bytes;
    for (const bool is_in : moves) {
        const auto event = inserted(is_in);
        bytes.insert(bytes.end(), event.begin(), event.end());
    }
    SwitchStream stream;
    std::span<const std::byte> left = bytes;
    while (!left.empty()) {
        const auto size = std::min<std::size_t>(left.size(), *rc::gen::inRange<std::size_t>(1, 60));
        stream.add(left.first(size));
        left = left.subspan(size);
    }
    RC_ASSERT(stream.are_in() == std::optional<bool>(moves.back()));
}

RC_GTEST_PROP(SwitchStream, AnyBytesAreTaken, (const std::vector<std::uint8_t>& noise)) {
    SwitchStream stream(true);
    stream.add(std::as_bytes(std::span(noise)));
    const auto state = stream.are_in();
    RC_ASSERT(state.has_value());
}

/// A folder of pipes that stand for input devices; the second one is the switch.
class HeadphoneSwitchTest : public testing::Test {
  protected:
    HeadphoneSwitchTest() {
        fs::create_directories(folder_);
        for (const char* name : {"event0", "event1", "mouse0"})
            EXPECT_EQ(mkfifo((folder_ / name).c_str(), 0600), 0);
        writer_ = Descriptor(::open((folder_ / "event1").c_str(), O_RDWR | O_CLOEXEC));
    }

    ~HeadphoneSwitchTest() override { fs::remove_all(folder_); }

    std::optional<SwitchDevice> open(const std::string& path) {
        opened_.push_back(fs::path(path).filename().string());
        if (opened_.back() != "event1" || !is_there_) return std::nullopt;
        return SwitchDevice{Descriptor(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)),
                            first_};
    }

    HeadphoneSwitch make() {
        return HeadphoneSwitch(folder_.string(), [this](const auto& path) { return open(path); });
    }

    fs::path folder_ = fs::temp_directory_path() / ("touchline-switch-" + std::to_string(getpid()));
    Descriptor writer_;
    std::vector<std::string> opened_;
    std::optional<bool> first_ = false;
    bool is_there_ = true;
};

TEST_F(HeadphoneSwitchTest, AsksTheDeviceFirstAndFollowsItsEvents) {
    HeadphoneSwitch headphones = make();
    EXPECT_EQ(headphones.are_in(0.0), false);
    EXPECT_EQ(opened_, (std::vector<std::string>{"event0", "event1"}));
    ASSERT_TRUE(write_all(writer_, inserted(true)));
    EXPECT_EQ(headphones.are_in(0.02), true);
    EXPECT_EQ(headphones.are_in(0.04), true);
    ASSERT_TRUE(write_all(writer_, inserted(false)));
    EXPECT_EQ(headphones.are_in(0.06), false);
}

TEST_F(HeadphoneSwitchTest, AfterLostEventsTheDeviceIsAskedAgain) {
    HeadphoneSwitch headphones = make();
    EXPECT_EQ(headphones.are_in(0.0), false);
    first_ = true;
    ASSERT_TRUE(write_all(writer_, bytes_of(EV_SYN, SYN_DROPPED, 0)));
    EXPECT_EQ(headphones.are_in(0.02), true);
}

TEST_F(HeadphoneSwitchTest, ComesAndGoesWithItsDevice) {
    is_there_ = false;
    HeadphoneSwitch headphones = make();
    EXPECT_EQ(headphones.are_in(0.0), std::nullopt);
    is_there_ = true;
    EXPECT_EQ(headphones.are_in(1.0), std::nullopt) << "looks every two seconds";
    EXPECT_EQ(headphones.are_in(2.1), false);
    is_there_ = false;
    writer_ = Descriptor();  // the last writer closes: the pipe ends
    EXPECT_EQ(headphones.are_in(2.2), std::nullopt);
}

TEST(OpenSwitch, WhatIsNoInputDeviceIsNoSwitch) {
    for (const char* path : {"/no/such/file", "/dev/null", "/etc/passwd", "/dev"})
        EXPECT_FALSE(open_switch(path)) << path;
    HeadphoneSwitch nowhere("/no/such/folder");
    EXPECT_EQ(nowhere.are_in(0.0), std::nullopt);
}

}  // namespace
}  // namespace touchline
