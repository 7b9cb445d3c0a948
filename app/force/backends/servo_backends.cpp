#include "app/force/backends/servo_backends.h"

#include "app/force/servo/inverse3_arm.h"
#include "app/force/servo/motors_device.h"
#include "app/force/servo/usb_device.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

bool is_usb_board(std::span<const std::string> words) {
    return device_of(words).has_value();
}

Result<OpenedDevice> open_usb_board(std::span<const std::string> words, const Opening& opening) {
    return device_of(words).and_then(
        [&opening](const UsbDevice& device) { return open_usb_device(device, opening); });
}

template <MotorsMake make>
bool are_motors(std::span<const std::string> words) {
    return motors_of(make, words).has_value();
}

template <MotorsMake make>
Result<OpenedDevice> open_motors_of(std::span<const std::string> words, const Opening& opening) {
    return motors_of(make, words).and_then([&opening](const MotorsDevice& device) {
        return open_motors(device, opening);
    });
}

bool is_arm(std::span<const std::string> words) {
    return words.size() == 1 && arm_address_of(words[0]).has_value();
}

Result<OpenedDevice> open_arm(std::span<const std::string> words, const Opening& opening) {
    if (words.size() != 1) return failure("not what the kiosk starts it with");
    return arm_address_of(words[0]).and_then(
        [&opening](const ArmAddress& address) { return open_inverse3(address, opening); });
}

constexpr std::array rows{
    ServoBackend{"usb-board", is_usb_board, open_usb_board},
    ServoBackend{"moteus", are_motors<MotorsMake::moteus>, open_motors_of<MotorsMake::moteus>},
    ServoBackend{"odrive", are_motors<MotorsMake::odrive>, open_motors_of<MotorsMake::odrive>},
    ServoBackend{"inverse3", is_arm, open_arm},
};

const ServoBackend* row_of(std::span<const std::string> words) {
    if (words.empty()) return nullptr;
    const auto* const found = std::ranges::find(rows, words.front(), &ServoBackend::name);
    return found != rows.end() ? found : nullptr;
}

}  // namespace

std::span<const ServoBackend> servo_backends() {
    return rows;
}

bool names_device(std::span<const std::string> words) {
    const ServoBackend* const row = row_of(words);
    return row != nullptr && row->is_sound(words.subspan(1));
}

Result<OpenedDevice> open_named_device(std::span<const std::string> words, const Opening& opening) {
    const ServoBackend* const row = row_of(words);
    if (row == nullptr)
        return failure("this servo knows no such device; use the kiosk of the same version");
    return row->open(words.subspan(1), opening);
}

}  // namespace touchline
