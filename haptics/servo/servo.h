// The servo: the loop that owns the device and turns motion into force, 1000 times a second. Only
// app/ knows whether it runs as a thread of the kiosk or as a process of its own (app/force/servo).
#pragma once

#include "config/types/contact_event.h"
#include "config/types/hand_state.h"
#include "config/types/pinned.h"
#include "config/types/result.h"
#include "haptics/collision/scene.h"
#include "haptics/device/force_device.h"
#include "haptics/pantograph/profile.h"
#include "haptics/servo/exchange.h"
#include "haptics/servo/real_time.h"
#include "haptics/servo/recorder.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace touchline {

struct ServoOptions {
    double period_s = 1e-3;
    bool is_real_time = true;        // try for real-time scheduling and locked memory
    std::size_t recorded_ticks = 0;  // newest ticks kept for recording(); 0: none
    MemoryLock lock = MemoryLock::as_touched;
    bool has_motors = false;     // force follows the real-time tier
    bool watches_kiosk = false;  // force needs the heartbeat in the channel
    double motor_heat = 0.0;     // of motors that another servo used before, >= 0 (MotorHeat)
};

/// Threads: one, next_event() also from one other. Only start() and stop() wait for the servo.
class Servo : private Pinned {
  public:
    Servo();
    /// Uses a channel owned by somebody else, which must outlive the servo, for commands, reports
    /// and events. Of the calls below, only start(), feel(), tier(), cut() and stop() then apply.
    explicit Servo(ServoChannel& channel);
    /// Calls stop().
    ~Servo();

    /// Takes the device and starts the loop: force off -> armed -> ramp -> live. Commands and a
    /// scene given before count from the first tick. Fails if the servo is already running or the
    /// thread cannot be made.
    [[nodiscard]] Result<void> start(std::unique_ptr<ForceDevice> device,
                                     const DeviceProfile& profile, const ServoOptions& options);

    /// Takes effect from the next tick on. A new radius or capture width goes through zero force,
    /// like a new scene; a new mode fades in under the hand (haptics/contact/contact_machine.h).
    void set(const ServoCommands& commands) { exchange_.set(commands); }

    /// Changes the picture: force fades to zero (<= 50 ms), the old contact is dropped, and force
    /// fades in. The servo keeps the scene alive as long as it needs it; the calling thread frees
    /// it.
    void feel(std::shared_ptr<const Scene> scene) { exchange_.feel(std::move(scene)); }

    /// The newest tick's hand state; the last tick's once the servo has stopped. O(1).
    [[nodiscard]] const HandState& latest() { return exchange_.report().hand; }

    /// The newest tick's force status.
    [[nodiscard]] ForceStatus force_status() { return exchange_.report().force; }

    /// Returns the oldest event not yet read. Call it until it returns nothing, at least every few
    /// seconds: when more than 1024 wait, the newest are dropped and counted. O(1).
    [[nodiscard]] std::optional<ContactEvent> next_event() { return exchange_.next_event(); }

    [[nodiscard]] std::uint64_t dropped_events() const { return exchange_.dropped_events(); }

    /// How well the loop keeps time; nothing while none runs.
    [[nodiscard]] std::optional<RealTimeTier> tier() const;

    /// How late the servo's ticks began.
    [[nodiscard]] const LatenessHistogram& lateness() const { return exchange_.channel().lateness; }

    /// Fades force out, writes zero torque, ends the loop and returns the device. Returns null if
    /// nothing runs.
    std::unique_ptr<ForceDevice> stop();

    /// Makes the next tick the last one, with zero torque. May be called from any thread and from a
    /// signal handler, but not during start() or stop().
    void cut() noexcept;

    /// The recorded ticks. Read them while nothing runs or while the recorder is held.
    [[nodiscard]] Recorder& recording() { return recorder_; }

  private:
    struct Running;

    ServoExchange exchange_;
    Recorder recorder_;
    std::unique_ptr<Running> running_;
};

}  // namespace touchline
