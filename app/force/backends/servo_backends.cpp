#include "app/force/backends/servo_backends.h"

#include "app/force/servo/inverse3_arm.h"
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

/// Its name, or nothing for the only one.
bool is_arm(std::span<const std::string> words) {
    return words.size() == 1 && (words[0].empty() || ArmName::of(words[0]));
}

Result<OpenedDevice> open_arm(std::span<const std::string> words, const Opening& opening) {
    if (!is_arm(words)) return failure("the name of the Inverse3 is none: see device.port");
    return open_inverse3(words[0], opening);
}

constexpr std::array rows{
    ServoBackend{"usb-board", is_usb_board, open_usb_board},
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
