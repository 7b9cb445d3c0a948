// The pantograph on the USB: which one, told from the kiosk to its servo in a few words, so that
// the servo reads no file; opened, and zeroed. Threads: any; the calls that open wait.
#pragma once

#include "app/servo/servo_program.h"
#include "config/settings/boards.h"
#include "config/types/calibration.h"
#include "config/types/result.h"

#include <span>
#include <string>
#include <vector>

namespace touchline {

/// One board, and what its unit is like.
struct UsbDevice {
    BoardId id;
    std::string serial;  // may be empty: the only board there is
    std::string profile;
    Calibration calibration;
};

/// For the command line of touchline-servo; device_of() reads the same back, bit for bit.
[[nodiscard]] std::vector<std::string> arguments_of(const UsbDevice& device);
[[nodiscard]] Result<UsbDevice> device_of(std::span<const std::string> arguments);

/// Opens the board and sets it up: the handle counts as being at home.
[[nodiscard]] Result<OpenedDevice> open_usb_device(const UsbDevice& device);

/// Zero torque on a board whose servo died.
[[nodiscard]] Result<void> zero_usb_device(const UsbDevice& device);

}  // namespace touchline
