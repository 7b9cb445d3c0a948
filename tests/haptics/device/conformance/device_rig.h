// What the conformance suite needs of a device: a driver, the emulator of what it drives and a
// hand, on one virtual clock. Each back-end gives one; the suite is written once.
#pragma once

#include "config/types/pinned.h"
#include "config/types/vec2.h"
#include "haptics/device/force_device.h"
#include "haptics/pantograph/profile.h"

#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace touchline {

/// Threads: one.
class DeviceRig : public Interface {
  public:
    /// The driver, also before open() and after a loss. Another one may come with open().
    [[nodiscard]] virtual ForceDevice& device() = 0;

    [[nodiscard]] virtual const DeviceProfile& profile() const = 0;

    /// Makes the driver ready for force, as the servo has it after homing and the test of the
    /// motors, or after a loss: with a new driver where the product makes a new one. False if that
    /// failed. Time may pass.
    [[nodiscard]] virtual bool open() = 0;

    /// Seconds on the clock, for ForceDevice::read().
    [[nodiscard]] virtual double now_s() const = 0;

    /// Lets time pass for the emulator, the hand and the line.
    virtual void pass(double span_s) = 0;

    // What a person does.

    /// The hand goes there at once by its own spring and mass, and stays.
    virtual void move_hand(Position p_D) = 0;

    // What happens to the line.

    /// Cuts it: nothing comes through any more, as when a plug is pulled or a service ends.
    virtual void cut() = 0;

    /// Nothing answers from now on, but the line stays, and what is sent arrives.
    virtual void fall_silent() = 0;

    /// Makes a line that was cut whole again. Then open() may be called.
    virtual void join() = 0;

    /// Spoils the next answer: some of its bits or words are others, by `seed`.
    virtual void garble_next(unsigned seed) = 0;

    /// Each answer of the next ticks comes later by late_s, in the same order.
    virtual void slow_answers(double late_s, int ticks) = 0;

    // What only a test can see.

    /// Where the handle is.
    [[nodiscard]] virtual Position true_p_D() const = 0;

    /// What the motors push the hand with now, within the plane; as they are, not as they were
    /// told.
    [[nodiscard]] virtual Force true_force_D() const = 0;

    /// True if the emulated device holds exactly zero, or has let its motors go.
    [[nodiscard]] virtual bool holds_zero() const = 0;
};

/// What a back-end promises; its README says the same.
struct RigPromises {
    double zero_s = 3e-3;       // from the first zero written until the device holds it
    double fresh_s = 4.5e-3;    // the age of what read() tells
    double loss_s = 20e-3;      // from a cut until read() tells nothing
    double silence_s = 10e-3;   // from the last answer until the device holds zero
    double place_m = 5e-4;      // read() against the true place
    double force_share = 0.05;  // the force made against the force told, as a share ...
    double force_N = 0.05;      // ... and besides
    bool needs_opening = true;  // without open() it never gets ready
    bool keeps_way = true;      // of a force above the limit; false: each motor ends at its own
    bool has_motors = true;     // false: software, which takes a zero for held once it is told
    std::optional<double>
        free_s;  // from a cut until its motors are free by themselves; nothing: never
};

struct RigRow {
    std::string_view name;  // letters and digits
    std::unique_ptr<DeviceRig> (*make)() = nullptr;
    RigPromises promises;
};

/// Every back-end, one row each. To add one, write its rig in this folder and its row in rigs.cpp.
[[nodiscard]] std::span<const RigRow> rig_rows();

}  // namespace touchline
