// The two tables of makes agree, and what they say to a make that there is not.
#include "app/force/backends/kiosk_backends.h"
#include "app/force/backends/servo_backends.h"
#include "app/force/servo/usb_device.h"
#include "config/types/choices.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::vector<std::string> named(const std::string& name, const std::vector<std::string>& words) {
    std::vector<std::string> all{name};
    all.insert(all.end(), words.begin(), words.end());
    return all;
}

TEST(Backends, BothTablesHaveTheSameMakesAndTheSettingNamesThem) {
    ASSERT_EQ(kiosk_backends().size(), servo_backends().size());
    for (std::size_t i = 0; i < kiosk_backends().size(); ++i) {
        const std::string_view name = kiosk_backends()[i].name;
        EXPECT_EQ(name, servo_backends()[i].name);
        EXPECT_NE(std::ranges::find(device_makes, name), device_makes.end()) << name;
    }
}

TEST(Backends, TheFirstIsTheSettingsDefault) {
    EXPECT_EQ(kiosk_backends().front().name, name_of(DeviceMake{}));
    EXPECT_TRUE(find_backend(name_of(DeviceMake{})).has_value());
}

TEST(Backends, AMakeThatThereIsNotIsOneLineThatSaysWhatToDo) {
    const auto found = find_backend("abacus");
    ASSERT_FALSE(found.has_value());
    EXPECT_NE(found.error().line.find("'abacus'; set device.make to one of usb-board"),
              std::string::npos)
        << found.error().line;
    std::ostringstream out;
    for (const DeviceAction action : {DeviceAction::list, DeviceAction::probe, DeviceAction::stop})
        EXPECT_EQ(command_device({action, "", "", "abacus", ""}, out).error().line,
                  found.error().line);
    EXPECT_TRUE(out.str().empty());
}

TEST(Backends, TheServoTakesWhatTheKioskMakesOfItsDevice) {
    UsbDevice device;
    device.serial = "A1";
    const auto words = arguments_of(device);
    EXPECT_TRUE(names_device(named("usb-board", words)));
    EXPECT_FALSE(names_device(named("abacus", words)));
    EXPECT_FALSE(names_device(named("usb-board", {"1", "2"})));
    EXPECT_FALSE(names_device(words)) << "the words of an older kiosk";
    EXPECT_TRUE(names_device(named("inverse3", {""})));
    EXPECT_TRUE(names_device(named("inverse3", {"04EA"})));
    EXPECT_FALSE(names_device(named("inverse3", {"04 EA"})));
    EXPECT_FALSE(names_device(named("inverse3", {})));
    EXPECT_FALSE(names_device({}));
    EXPECT_FALSE(open_named_device(named("abacus", words), {}).has_value());
}

}  // namespace
}  // namespace touchline
