// The pantograph on the USB: which one, told from the kiosk to its servo in a few words, so that
// the servo reads no file; opened, and zeroed. Threads: any; the calls that open wait.
#pragma once

#include "app/servo/messages.h"
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
    std::string serial;   // may be empty: the only board there is
    std::string profile;  // empty: nobody has said yet which kind it is
    Calibration calibration;
    bool is_homed_first = true;  // by a person, with words; else the handle counts as being at home
};

/// For the command line of touchline-servo; device_of() reads the same back, bit for bit.
[[nodiscard]] std::vector<std::string> arguments_of(const UsbDevice& device);
[[nodiscard]] Result<UsbDevice> device_of(std::span<const std::string> arguments);

/// Opens the board, sets it up, and has the handle homed if that is asked for. An error where
/// nobody said which kind it is.
[[nodiscard]] Result<OpenedDevice> open_usb_device(const UsbDevice& device, const Opening& opening);

/// Zero torque on a board whose servo died, confirmed; the board at `bus_path` where that is told,
/// however many boards there are.
[[nodiscard]] Result<void> zero_usb_device(const UsbDevice& device,
                                           const std::string& bus_path = {});

/// Zero torque at once, by the node that its servo held. True: it was sent.
[[nodiscard]] bool cut_usb_device(const UsbDevice& device, const HeldBoard& held);

}  // namespace touchline
