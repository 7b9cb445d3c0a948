#include "app/force/device/board_files.h"
#include "app/force/servo/servo_process.h"
#include "app/force/servo/servo_thread.h"
#include "app/force/servo/usb_search.h"
#include "app/isolation/process/places.h"
#include "app/main/kiosk_window.h"
#include "config/types/utf8.h"
#include "haptics/device/simulated/simulated_pantograph.h"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace touchline {
namespace {

UnitSettings unit_of(const UsbDevice& device) {
    return {device.serial, device.profile, device.calibration};
}

/// Stores it for the next visit and the next servo.
std::vector<std::string> keep(const UsbDevice& device) {
    const auto kept = keep_unit(board_files(), unit_of(device));
    if (!kept) fmt::print(stderr, "touchline: {}\n", plain_line(kept.error().line));
    return arguments_of(device);
}

/// Stores the unit as homing found it. A unit without a serial number is measured each time.
std::vector<std::string> keep_home(UsbDevice& device, const Message& message) {
    const auto found = calibration_of(message, device.calibration);
    if (!found || device.serial.empty()) return arguments_of(device);
    device.calibration = *found;
    return keep(device);
}

std::vector<std::string> keep_kind(UsbDevice& device, const std::string& kind) {
    const auto profile = find_profile(kind);
    if (!profile) return arguments_of(device);
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

KioskServo with_motors(const UsbDevice& found) {
    // From here on only the guard uses it.
    const auto device = std::make_shared<UsbDevice>(found);
    ServoProcessOptions options;
    options.program = companion("touchline-servo");
    options.arguments = arguments_of(*device);
    options.zero_torque = [device](const std::string& bus_path) {
        return zero_usb_device(*device, bus_path);
    };
    options.cut_torque = [device](const HeldBoard& held) { return cut_usb_device(*device, held); };
    options.keep_home = [device](const Message& message) { return keep_home(*device, message); };
    options.keep_kind = [device](const std::string& kind) { return keep_kind(*device, kind); };
    options.hand_over = [device](const Handover& handover) {
        UsbDevice next = *device;
        next.handover = handover;
        return arguments_of(next);
    };
    options.kind = found.profile;
    options.summons = environment("TOUCHLINE_SERVO_SOCKET");
    KioskServo servo;
    servo.client = std::make_unique<ServoProcess>(std::move(options));
    servo.has_motors = true;
    servo.profile = profile_or_default(found.profile);
    servo.hand_words = "device {0}";
    servo.hand_name = name_of(found);
    return servo;
}

Result<KioskServo> simulated(const std::shared_ptr<MouseHand>& hand) {
    auto thread = std::make_unique<ServoThread>();
    auto started = thread->start(
        std::make_unique<SimulatedPantograph>(default_profile(), SimulationOptions{}, hand),
        default_profile());
    if (!started) return tl::unexpected(started.error());
    KioskServo servo;
    servo.client = std::move(thread);
    servo.hand_words = "mouse, no device";
    return servo;
}

}  // namespace

Result<KioskServo> start_servo(const std::shared_ptr<MouseHand>& hand) {
    const auto settings = read_board_files(board_files());
    const auto device = settings
                            ? find_usb_device(*settings)
                            : Result<std::optional<UsbDevice>>(tl::unexpected(settings.error()));
    if (device && *device) {
        KioskServo servo = with_motors(**device);
        servo.note = settings->notice;
        return servo;
    }
    auto servo = simulated(hand);
    if (servo)
        servo->note = device ? "there is no pantograph: the mouse is the hand of a simulated one; "
                               "plug it in, then start the kiosk again"
                             : device.error().line;
    return servo;
}

}  // namespace touchline
