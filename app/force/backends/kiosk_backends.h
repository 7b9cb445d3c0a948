// The makes of device that the kiosk can use, a row each: how it is looked for, what its servo is
// started with, how its motors are turned off when the servo died, and what touchline device does
// with it. A new make is a row here, a row in servo_backends.cpp, and a rig in the conformance
// suite. Threads: constant data; the calls wait.
#pragma once

#include "app/force/device/device_command.h"
#include "app/force/servo/servo_process.h"
#include "config/types/result.h"
#include "haptics/pantograph/profile.h"

#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace touchline {

/// A device with motors that was found.
struct MotorDevice {
    /// All but the program and the summons. The arguments begin with the row's name.
    ServoProcessOptions servo;
    DeviceProfile profile;
    std::string name;    // kind and serial number, as far as they are known
    std::string notice;  // for the log; may be empty
};

/// The end of a command for one row. If nothing of the row was there, `result` is the error that
/// says what was looked for.
struct CommandEnd {
    bool was_there = false;
    Result<void> result;
};

struct KioskBackend {
    std::string_view name;  // of the setting device.make, and of the row of servo_backends.h
    /// `port`: the setting device.port; empty: the only one. Returns nothing if there is none and
    /// that is no fault. What is there but cannot be used is an error, with what to do about it.
    Result<std::optional<MotorDevice>> (*find)(const std::string& port) = nullptr;
    CommandEnd (*command)(const DeviceCommandOptions& options, std::ostream& out) = nullptr;
};

[[nodiscard]] std::span<const KioskBackend> kiosk_backends();

/// The error lists the names.
[[nodiscard]] Result<KioskBackend> find_backend(std::string_view name);

/// Does a command of touchline device: list and stop for every row, or the named one; others for
/// the named one or else the first. Writes to `out` what was found and what to do.
[[nodiscard]] Result<void> command_device(const DeviceCommandOptions& options, std::ostream& out);

}  // namespace touchline
