// The servo: the loop that owns the device and turns motion into force, 1000 times a second. Only
// app/ knows whether it is a thread of the kiosk or a process (app/servo).
#pragma once

#include "config/types/contact_event.h"
#include "config/types/hand_state.h"
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

namespace touchline {

struct ServoOptions {
    double period_s = 1e-3;
    bool is_real_time = true;        // try for real-time scheduling and locked memory
    std::size_t recorded_ticks = 0;  // newest ticks kept for recording(); 0: none
    MemoryLock lock = MemoryLock::as_touched;
    bool has_motors = false;     // force follows the real-time tier
    bool watches_kiosk = false;  // force needs the heartbeat in the channel
};

/// Threads: one, next_event() also from one other. Only start() and stop() wait for the servo.
class Servo {
  public:
    Servo();
    /// Commands, reports and events cross in a channel of somebody else's, which must outlive this;
    /// of the calls below only start(), feel(), tier(), cut() and stop() are for such a servo.
    explicit Servo(ServoChannel& channel);
    /// Stops.
    ~Servo();
    Servo(const Servo&) = delete;
    Servo(Servo&&) = delete;
    Servo& operator=(const Servo&) = delete;
    Servo& operator=(Servo&&) = delete;

    /// Takes the device and starts the loop, force off -> armed -> ramp -> live. Commands and scene
    /// given before count from the first tick. Fails when the servo runs already or the thread
    /// cannot be made.
    [[nodiscard]] Result<void> start(std::unique_ptr<ForceDevice> device,
                                     const DeviceProfile& profile, const ServoOptions& options);

    /// From the next tick on. A change of radius or capture width goes through zero force like a
    /// new scene; one of mode fades under the hand (haptics/contact/gap_fade.h).
    void set(const ServoCommands& commands);

    /// A new picture: force fades to zero (<= 50 ms), the old contact is dropped, force fades in.
    /// The servo keeps the scene alive as long as it needs it; this thread frees it.
    void feel(std::shared_ptr<const Scene> scene);

    /// The newest tick. O(1); while nothing runs, the last one there was.
    [[nodiscard]] const HandState& latest();

    /// Of the newest tick.
    [[nodiscard]] ForceStatus force_status();

    /// The oldest event not yet read; to be called until there is none, at least every few seconds:
    /// of more than 1024 that wait, the newest are dropped and counted. O(1).
    [[nodiscard]] std::optional<ContactEvent> next_event();

    [[nodiscard]] std::uint64_t dropped_events() const;

    /// How far the loop can be trusted to be in time; nothing while none runs.
    [[nodiscard]] std::optional<RealTimeTier> tier() const;

    /// How late its ticks began.
    [[nodiscard]] const LatenessHistogram& lateness() const { return exchange_.channel().lateness; }

    /// Fades force out, writes zero torque, ends the loop and gives the device back. Null when
    /// nothing runs.
    std::unique_ptr<ForceDevice> stop();

    /// Zero torque with the next tick, which is the last. From any thread and from a handler of
    /// signals, while start() or stop() do not run.
    void cut() noexcept;

    /// The ticks recorded; to be read while nothing runs, or while it is held.
    [[nodiscard]] Recorder& recording();

  private:
    struct Running;

    ServoExchange exchange_;
    Recorder recorder_;
    std::unique_ptr<Running> running_;
};

}  // namespace touchline
