// The row of the Inverse3: the kiosk's side. Its service names the devices and tells how they are,
// so nothing is kept of a unit. Threads: any; the calls wait.
#pragma once

#include "app/force/backends/kiosk_backends.h"

#include <iosfwd>
#include <optional>
#include <string>

namespace touchline {

/// As KioskBackend::find. `port`: as arm_address_of() reads it.
[[nodiscard]] Result<std::optional<MotorDevice>> find_inverse3(const std::string& port);

/// As KioskBackend::command. Without a `port`, `serial` is the device's name.
[[nodiscard]] CommandEnd command_inverse3(const DeviceCommandOptions& options, std::ostream& out);

}  // namespace touchline
