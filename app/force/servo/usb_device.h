// The pantograph on the USB. The kiosk tells its servo in a few words which one it is, so that the
// servo reads no file. Opens and zeroes it. Threads: any; the calls that open wait.
#pragma once

#include "app/force/servo/messages.h"
#include "app/force/servo/servo_program.h"
#include "config/settings/boards.h"
#include "config/types/calibration.h"
#include "config/types/result.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace touchline {

/// One board, and the properties of its unit.
struct UsbDevice {
    BoardId id;
    std::string serial;   // may be empty: the only board there is
    std::string profile;  // empty: nobody has said yet which kind it is
    Calibration calibration;
    std::optional<Handover> handover = {};  // a servo that died left the board at work
    bool is_homed_first = true;  // by a person, with words; else the handle counts as being at home
};

/// For the command line of touchline-servo. device_of() reads the same device back, bit for bit.
[[nodiscard]] std::vector<std::string> arguments_of(const UsbDevice& device);
[[nodiscard]] Result<UsbDevice> device_of(std::span<const std::string> arguments);

/// Takes the board over as another servo left it, if it counted all the time. Else sets it up, and
/// has the handle homed if that is asked for. Fails if nobody said which kind it is.
[[nodiscard]] Result<OpenedDevice> open_usb_device(const UsbDevice& device, const Opening& opening);

/// Writes zero torque, confirmed, on a board whose servo died. Takes the board at `bus_path` if
/// that is given, however many boards there are. The result is `unknown` or `kept`.
[[nodiscard]] Result<ZeroedBoard> zero_usb_device(const UsbDevice& device,
                                                  const std::string& bus_path = {});

/// Writes zero torque at once, by the node that its servo held. True if it was sent.
[[nodiscard]] bool cut_usb_device(const UsbDevice& device, const HeldBoard& held);

}  // namespace touchline
