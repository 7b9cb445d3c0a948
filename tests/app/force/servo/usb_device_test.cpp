#include "app/force/servo/usb_device.h"

#include "app/force/device/board_files.h"
#include "app/force/servo/usb_search.h"

#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

UsbDevice some_device() {
    UsbDevice device;
    device.id.vendor = 0x2341;
    device.id.product = 0x804d;
    device.serial = "A1B2 C3";
    device.profile = "2diy-gen3";
    device.calibration = {
        {}, {0.01, -1.0 / 30.0}, 1.0154, {true, false, true}, {false, true, true}, true, true, 0.1};
    return device;
}

TEST(UsbDevice, ArgumentsReadBackTheSameBits) {
    for (const bool has_limit : {true, false}) {
        UsbDevice device = some_device();
        if (!has_limit) device.calibration.torque_limit_Nm.reset();
        const auto back = device_of(arguments_of(device)).value();
        EXPECT_EQ(back.id.vendor, device.id.vendor);
        EXPECT_EQ(back.id.product, device.id.product);
        EXPECT_TRUE(back.id.may_probe);
        EXPECT_EQ(back.serial, device.serial);
        EXPECT_EQ(back.profile, device.profile);
        EXPECT_EQ(back.calibration.stop_off, device.calibration.stop_off);
        EXPECT_EQ(back.calibration.scale, device.calibration.scale);
        EXPECT_EQ(back.calibration.encoders, device.calibration.encoders);
        EXPECT_EQ(back.calibration.motors, device.calibration.motors);
        EXPECT_TRUE(back.calibration.is_measured);
        EXPECT_TRUE(back.calibration.has_all_counts);
        EXPECT_EQ(back.calibration.torque_limit_Nm, device.calibration.torque_limit_Nm);
    }
}

TEST(UsbDevice, AHandoverReadsBackTheSameBits) {
    UsbDevice device = some_device();
    device.handover = {{{0.1, -1.0 / 7.0}, 12}, {1.0 / 3.0, 2.0}, 123456789012345, 0.25, "1-2.3"};
    const std::vector<std::string> sound = arguments_of(device);
    const auto back = device_of(sound).value().handover.value();
    EXPECT_EQ(back.place.offset, device.handover->place.offset);
    EXPECT_EQ(back.place.slept_ns, device.handover->place.slept_ns);
    EXPECT_EQ(back.last, device.handover->last);
    EXPECT_EQ(back.seen_ns, device.handover->seen_ns);
    EXPECT_EQ(back.motor_heat, device.handover->motor_heat);
    EXPECT_EQ(back.bus_path, device.handover->bus_path);
    EXPECT_FALSE(device_of(arguments_of(some_device())).value().handover.has_value());
    for (std::size_t word = 13; word < sound.size() - 1; ++word) {
        auto damaged = sound;
        damaged[word] = "nan";
        EXPECT_FALSE(device_of(damaged).has_value()) << word;
    }
}

TEST(UsbDevice, ArgumentsOutOfRangeAreRefused) {
    const std::vector<std::string> sound = arguments_of(some_device());
    for (const std::size_t number : {0U, 1U, 5U, 6U, 7U, 8U, 9U, 11U}) {
        for (const char* const bad : {"x", "1x", "nan", "inf", "-7", "99999999"}) {
            auto damaged = sound;
            damaged[number] = bad;
            EXPECT_FALSE(device_of(damaged).has_value()) << number << ' ' << bad;
        }
    }
    EXPECT_FALSE(device_of(std::vector<std::string>{}).has_value());
}

TEST(UsbDevice, UnknownProfileIsOneLine) {
    UsbDevice device = some_device();
    device.profile = "none";
    const auto opened = open_usb_device(device, {});
    ASSERT_FALSE(opened.has_value());
    EXPECT_NE(opened.error().line.find("none"), std::string::npos);
}

TEST(UsbSearch, TheTableOfBoardsIsFound) {
    const auto settings = read_board_files(board_files());
    ASSERT_TRUE(settings.has_value());
    EXPECT_FALSE(settings->boards.empty());
}

}  // namespace
}  // namespace touchline
