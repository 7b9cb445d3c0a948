// The program touchline-servo: owns the device, feels the maps that the kiosk sends, and never
// leaves torque on. Small on purpose: no OpenCV, no OpenGL, no file formats.
#pragma once

#include "app/servo/torque_cut.h"
#include "config/types/result.h"
#include "haptics/device/force_device.h"
#include "haptics/pantograph/profile.h"

#include <functional>
#include <memory>

namespace touchline {

struct OpenedDevice {
    std::unique_ptr<ForceDevice> device;
    DeviceProfile profile;
    bool has_motors = true;  // false: a simulation, whose force no tier limits
    EmergencyZero zero;      // valid as long as the device
};

/// Opens the device that this servo is for; may wait some seconds. The error is told to the kiosk.
using DeviceOpener = std::function<Result<OpenedDevice>()>;

/// Runs the servo until the kiosk asks for the end, dies, or a signal ends it. `socket_number`: the
/// kiosk's socket, the first message on it the shared region. The exit status: 0 when it ended as
/// asked, 1 when it could not start.
/// Threads: call it from the main thread of a process of its own. Scenes are built in that thread;
/// the loop runs in one of its own.
[[nodiscard]] int run_servo_program(int socket_number, const DeviceOpener& open_device);

}  // namespace touchline
