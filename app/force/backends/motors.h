// The rows of pantographs whose motors have controllers of their own: the kiosk's side, which finds
// the port, and reads and keeps how a unit's motors stand to its joints. Threads: any; the calls
// wait.
#pragma once

#include "app/force/backends/kiosk_backends.h"
#include "app/force/servo/motors_device.h"
#include "config/settings/motor_units.h"

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// TOUCHLINE_MOTORS, or touchline/motors.toml in the user's folder of settings.
[[nodiscard]] std::filesystem::path motors_file();

/// What is kept for the make; nothing if it was never set up.
[[nodiscard]] Result<std::optional<MotorUnit>> stored_motors(MotorsMake make);

/// Keeps the unit, in place of what was kept for its make.
[[nodiscard]] Result<void> keep_motors(const MotorUnit& unit);

[[nodiscard]] std::string_view name_of(MotorsMake make);

/// The adapters of the make that are plugged in.
[[nodiscard]] std::vector<std::string> motor_ports(MotorsMake make);

/// The named port, or else the only adapter; nothing if there is none. Fails if there are several.
[[nodiscard]] Result<std::optional<std::string>> motor_port(MotorsMake make,
                                                            const std::string& named);

/// The unit as a device at a port.
[[nodiscard]] MotorsDevice device_at(const std::string& port, MotorsMake make,
                                     const MotorUnit& unit);

/// As KioskBackend::find. Without a port, the only adapter of the make that the system has named
/// by its kind (/dev/serial/by-id). Fails if the unit was never set up.
[[nodiscard]] Result<std::optional<MotorDevice>> find_moteus(const std::string& port);
[[nodiscard]] Result<std::optional<MotorDevice>> find_odrive(const std::string& port);

/// As KioskBackend::command. home: the person holds the handle at home, and what the encoders tell
/// there is kept.
[[nodiscard]] CommandEnd command_moteus(const DeviceCommandOptions& options, std::ostream& out);
[[nodiscard]] CommandEnd command_odrive(const DeviceCommandOptions& options, std::ostream& out);

}  // namespace touchline
