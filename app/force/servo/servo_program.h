// The program touchline-servo: owns the device, feels the maps that the kiosk sends, and never
// leaves torque on. Kept small: no OpenCV, no OpenGL, no file formats.
//
// Whatever ends the process, the torque goes to zero first, because the board holds its last torque
// forever: it handles signals that ask for an end, signals of a crash, and the kiosk's death.
#pragma once

#include "app/force/servo/messages.h"
#include "config/types/calibration.h"
#include "config/types/pinned.h"
#include "config/types/result.h"
#include "haptics/device/board/usb_boards.h"
#include "haptics/device/force_device.h"
#include "haptics/pantograph/profile.h"
#include "haptics/servo/exchange.h"
#include "haptics/servo/servo.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// Writes zero torque from a signal handler, to a device that nobody else uses at that moment. It
/// does not allocate and, as far as that is possible, takes no lock that the crashed code may hold.
struct EmergencyZero {
    void (*write)(void* device) noexcept = nullptr;  // null: nothing to write to
    void* device = nullptr;
};

/// While one lives (at most one may):
///   SIGTERM, SIGINT      force fades out, then the loop ends
///   SIGHUP               the kiosk died: zero with the next tick
///   SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU
///                        zero with the next tick; 3 ms later zero from the handler, for the loop
///                        itself may have crashed; then the process dies of the signal
/// Threads: made and destroyed by the main thread, with the servo running in between.
class ZeroOnSignal : private Pinned {
  public:
    ZeroOnSignal(Servo& servo, ServoChannel& channel, const EmergencyZero& zero);
    ~ZeroOnSignal();

    /// True if an end was asked for or the kiosk died.
    [[nodiscard]] bool is_end_asked() const;
};

struct OpenedDevice {
    std::unique_ptr<ForceDevice> device;
    DeviceProfile profile;
    bool has_motors = true;  // false: a simulation, whose force no tier limits
    EmergencyZero zero;      // valid as long as the device is
    /// The handle's place is unknown: no angles come, and it must be homed. Valid as long as the
    /// device is.
    const std::atomic<bool>* has_lost_place = nullptr;
    std::optional<HandlePlace> place = {};  // for a servo that follows this one
    double motor_heat = 0.0;                // as in ServoOptions
    /// Ends the device's work, after the loop. False if it did not confirm zero torque. None: there
    /// is nothing to confirm.
    std::function<bool()> release;
    /// Says in one line why the device gives no place, if it knows; else an empty one. Asked once
    /// its loop has ended. None: it never knows.
    std::function<std::string()> trouble = {};
};

/// What a device may need from the program while a person homes it.
struct Opening {
    std::function<void(const std::string&)> say;   // what the person has to do now; empty: nothing
    std::function<bool()> goes_on;                 // asked all the time; false: give up
    std::function<void(const Calibration&)> keep;  // found for this unit, for the next time
    /// Called with true before a torque is asked of the device, and with false once it holds zero
    /// again, by one thread that calls goes_on every few milliseconds meanwhile.
    std::function<void(bool)> mark_force;
    /// Called as soon as a board is open, so that the guard of this process can turn its motors
    /// off.
    std::function<void(const UsbNode&)> share;
    std::vector<std::string> words;  // the kiosk's words for the device; may be none
};

/// Opens the device that this servo is for. It may wait for minutes as long as it calls goes_on.
/// The kiosk is told the error.
using DeviceOpener = std::function<Result<OpenedDevice>(const Opening&)>;

/// Runs the servo until the kiosk asks for the end, dies, or a signal ends it. `socket_number`: the
/// kiosk's socket; the words of the device, if any, and the shared region come first. The exit
/// status is 0 if it ended as asked with zero torque, 1 if it could not start, lost the device, or
/// left it in doubt. Threads: call it from the main thread of a process of its own. That thread
/// builds the scenes; the loop runs on a thread of its own.
[[nodiscard]] int run_servo_program(int socket_number, const DeviceOpener& open_device);

}  // namespace touchline
