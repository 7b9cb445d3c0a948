// The row of the pantograph's board on the USB: the kiosk's side, which reads and keeps files.
// Threads: any; the calls wait.
#pragma once

#include "app/force/backends/kiosk_backends.h"

#include <iosfwd>
#include <optional>
#include <string>

namespace touchline {

/// As KioskBackend::find. A board has no port: units are told apart by serial number.
[[nodiscard]] Result<std::optional<MotorDevice>> find_usb_board(const std::string& port);

/// As KioskBackend::command. SIGINT and SIGTERM end it with zero torque.
[[nodiscard]] CommandEnd command_usb_board(const DeviceCommandOptions& options, std::ostream& out);

}  // namespace touchline
