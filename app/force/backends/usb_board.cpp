#include "app/force/backends/usb_board.h"

#include "app/force/device/board_files.h"
#include "app/force/servo/usb_search.h"
#include "config/types/utf8.h"

#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace touchline {
namespace {

std::vector<std::string> words_of(const UsbDevice& device) {
    std::vector<std::string> words{"usb-board"};
    for (std::string& word : arguments_of(device)) words.push_back(std::move(word));
    return words;
}

UnitSettings unit_of(const UsbDevice& device) {
    return {device.serial, device.profile, device.calibration};
}

/// Stores it for the next visit and the next servo.
std::vector<std::string> keep(const UsbDevice& device) {
    const auto kept = keep_unit(board_files(), unit_of(device));
    if (!kept) fmt::print(stderr, "touchline: {}\n", plain_line(kept.error().line));
    return words_of(device);
}

/// Stores the unit as homing found it. A unit without a serial number is measured each time.
std::vector<std::string> keep_home(UsbDevice& device, const Message& message) {
    const auto found = calibration_of(message, device.calibration);
    if (!found || device.serial.empty()) return words_of(device);
    device.calibration = *found;
    return keep(device);
}

std::vector<std::string> keep_kind(UsbDevice& device, const std::string& kind) {
    const auto profile = find_profile(kind);
    if (!profile) return words_of(device);
    UnitSettings taken = as_kind(unit_of(device), *profile);
    device.profile = std::move(taken.profile);
    device.calibration = taken.calibration;
    return keep(device);
}

/// The device's kind and serial number, as far as they are known.
std::string name_of(const UsbDevice& device) {
    const bool has_both = !device.profile.empty() && !device.serial.empty();
    return device.profile + (has_both ? " " : "") + device.serial;
}

MotorDevice with_motors(const UsbDevice& found) {
    // Only the guard uses it from here on.
    const auto device = std::make_shared<UsbDevice>(found);
    MotorDevice made;
    ServoProcessOptions& servo = made.servo;
    servo.arguments = words_of(*device);
    servo.zero_torque = [device](const std::string& bus_path) {
        return zero_usb_device(*device, bus_path);
    };
    servo.cut_torque = [device](const HeldBoard& held) { return cut_usb_device(*device, held); };
    servo.keep_home = [device](const Message& message) { return keep_home(*device, message); };
    servo.keep_kind = [device](const std::string& kind) { return keep_kind(*device, kind); };
    servo.hand_over = [device](const Handover& handover) {
        UsbDevice next = *device;
        next.handover = handover;
        return words_of(next);
    };
    servo.kind = found.profile;
    made.profile = profile_or_default(found.profile);
    made.name = name_of(found);
    return made;
}

}  // namespace

Result<std::optional<MotorDevice>> find_usb_board(const std::string& /*port*/) {
    const auto settings = read_board_files(board_files());
    if (!settings) return tl::unexpected(settings.error());
    const auto device = find_usb_device(*settings);
    if (!device) return tl::unexpected(device.error());
    if (!*device) return std::nullopt;
    MotorDevice made = with_motors(**device);
    made.notice = settings->notice;
    return made;
}

}  // namespace touchline
