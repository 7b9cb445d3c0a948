// How a guard of the tests and benches starts `servo_rig usb`, a servo with the one board on the
// USB, with all that the kiosk gives it for a board that its servo left. Threads: values.
#pragma once

#include "app/force/servo/servo_process.h"
#include "app/force/servo/usb_device.h"

#include <string>
#include <vector>

namespace touchline {

/// Returns the words of a command line of `servo_rig`.
[[nodiscard]] inline std::vector<std::string> usb_words(const UsbDevice& device) {
    std::vector<std::string> words = arguments_of(device);
    words.insert(words.begin(), "usb");
    return words;
}

/// `program` is a servo_rig.
[[nodiscard]] inline ServoProcessOptions usb_servo(const std::string& program,
                                                   const UsbDevice& device) {
    ServoProcessOptions options{program, usb_words(device), [device](const std::string& bus_path) {
                                    return zero_usb_device(device, bus_path);
                                }};
    options.cut_torque = [device](const HeldBoard& held) { return cut_usb_device(device, held); };
    options.hand_over = [device](const Handover& handover) {
        UsbDevice next = device;
        next.handover = handover;
        return usb_words(next);
    };
    return options;
}

}  // namespace touchline
