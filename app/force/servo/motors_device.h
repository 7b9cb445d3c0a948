// A pantograph whose motors have controllers of their own, as a servo's device. The kiosk tells its
// servo in a few words where they are plugged in and how they stand to the joints, so that the
// servo reads no file. Threads: any; the calls that open wait.
#pragma once

#include "app/force/servo/servo_program.h"
#include "config/types/result.h"
#include "haptics/device/drives/joint_drives.h"
#include "haptics/device/drives/motor_pantograph.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace touchline {

enum class MotorsMake : std::uint8_t { moteus, odrive };

/// Where the controllers are, and how a unit's motors stand to its joints.
struct MotorsDevice {
    MotorsMake make = MotorsMake::moteus;
    std::string port;                       // of a serial port; for moteus also a CAN interface's
    std::array<std::uint8_t, 2> ids{1, 2};  // of moteus controllers: 1 to 126, different
    JointDrives drives;
};

/// Returns words for the command line of touchline-servo. motors_of() reads the same back, bit for
/// bit.
[[nodiscard]] std::vector<std::string> arguments_of(const MotorsDevice& device);
[[nodiscard]] Result<MotorsDevice> motors_of(MotorsMake make, std::span<const std::string> words);

/// Opens the port and makes the driver, which is not opened yet. Fails in one line.
[[nodiscard]] Result<std::unique_ptr<MotorPantograph>> take_motors(const MotorsDevice& device);

/// Arms the controllers and has a person at the handle let the motors be tried. Nothing is homed:
/// the encoders tell where the handle is, or it fails.
[[nodiscard]] Result<OpenedDevice> open_motors(const MotorsDevice& device, const Opening& opening);

/// Lets the motors of a servo that died go, confirmed. Without it their watchdogs do so.
[[nodiscard]] Result<void> zero_motors(const MotorsDevice& device);

}  // namespace touchline
