// The program touchline-servo: owns the device, feels the maps that the kiosk sends, and never
// leaves torque on. Small on purpose: no OpenCV, no OpenGL, no file formats.
#pragma once

#include "app/servo/zero_on_signal.h"
#include "config/types/calibration.h"
#include "config/types/result.h"
#include "haptics/device/force_device.h"
#include "haptics/device/usb_node.h"
#include "haptics/pantograph/profile.h"

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace touchline {

struct OpenedDevice {
    std::unique_ptr<ForceDevice> device;
    DeviceProfile profile;
    bool has_motors = true;  // false: a simulation, whose force no tier limits
    EmergencyZero zero;      // valid as long as the device
    /// Where the handle is is not known any more: no angles come, and it must be homed. As long as
    /// the device.
    const std::atomic<bool>* has_lost_place = nullptr;
    /// Ends what the device does, after the loop. False when it did not confirm zero torque. None:
    /// nothing to confirm.
    std::function<bool()> release;
};

/// What a device may need of the program while a person homes it.
struct Opening {
    std::function<void(const std::string&)> say;   // what the person is to do now; empty: nothing
    std::function<bool()> goes_on;                 // to be asked all the time; false: give up
    std::function<void(const Calibration&)> keep;  // found for this unit, for the next time
    /// To be told true before a torque is asked of the device, false once it holds zero again, by
    /// one thread that asks whether it goes on every few milliseconds meanwhile.
    std::function<void(bool)> mark_force;
    /// As soon as a board is opened: whoever guards this process can turn its motors off by it.
    std::function<void(const UsbNode&)> share;
    std::vector<std::string> words;  // that the kiosk named the device with; may be none
};

/// Opens the device that this servo is for; may wait for minutes as long as it asks whether it goes
/// on. The error is told to the kiosk.
using DeviceOpener = std::function<Result<OpenedDevice>(const Opening&)>;

/// Runs the servo until the kiosk asks for the end, dies, or a signal ends it. `socket_number`: the
/// kiosk's socket; the messages that come first are words of the device, if any, and the shared
/// region. The exit status: 0 when it ended as asked with zero torque, 1 when it could not start,
/// lost the device, or left it in doubt. Threads: call it from the main thread of a process of its
/// own. Scenes are built in that thread; the loop runs in one of its own.
[[nodiscard]] int run_servo_program(int socket_number, const DeviceOpener& open_device);

}  // namespace touchline
