// The kiosk's view of the servo, wherever it runs: a thread of the kiosk for a simulated device, a
// process for one with motors.
// Threads: all calls from the kiosk's main thread except next_event(), which one other thread may
// call until stop(); none of them waits for the servo but stop().
#pragma once

#include "app/force/servo/messages.h"
#include "config/types/contact_event.h"
#include "config/types/hand_state.h"
#include "config/types/pinned.h"
#include "config/types/tactile_map.h"
#include "haptics/collision/scene.h"
#include "haptics/servo/exchange.h"
#include "haptics/servo/real_time.h"
#include "haptics/servo/recording.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace touchline {

/// A picture to be felt, and what its scene was built from, for a servo that builds its own.
struct FeltPicture {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const TactileMap> map;
    SceneOrder order;
    RecordedMap recorded;  // what the black box may record about it
};

class ServoClient : public Interface {
  public:
    /// Stops the servo.

    /// As Servo::set().
    virtual void set(const ServoCommands& commands) = 0;

    /// As Servo::feel(). Not null.
    virtual void feel(const FeltPicture& picture) = 0;

    /// The newest tick, always sound. While no servo runs, the last one without force. The kiosk
    /// must call this at least twice a second, or it counts as dead.
    [[nodiscard]] virtual const HandState& latest() = 0;

    /// The same tick's force status.
    [[nodiscard]] virtual ForceStatus force_status() = 0;

    /// As Servo::next_event(); one thread only.
    [[nodiscard]] virtual std::optional<ContactEvent> next_event() = 0;

    /// Nothing while no servo runs.
    [[nodiscard]] virtual std::optional<RealTimeTier> tier() const = 0;

    /// How late the ticks began since the servo started; nothing while none runs. The call takes
    /// some 30 us.
    [[nodiscard]] virtual LatenessBars lateness() const = 0;

    /// Counts on while the servo is looked after: its ticks, or the turns of the guard that watches
    /// it, which go on without a device.
    [[nodiscard]] virtual std::uint64_t beats() = 0;

    /// What happened to the servo since the last call: a line for the operator; empty: nothing.
    [[nodiscard]] virtual std::string take_notice() = 0;

    /// What the person at the handle has to do now, while the device is homed; empty: nothing.
    [[nodiscard]] virtual std::string device_words() = 0;

    /// Turns the force off and homes the handle anew. From then on device_words() belongs to the
    /// new homing. A simulated device needs none.
    virtual void home_again() = 0;

    /// The profile that the device is taken for. Empty: nobody has said which it is, and no servo
    /// drives it. Nothing: the device is simulated.
    [[nodiscard]] virtual std::optional<std::string> kind() const { return std::nullopt; }

    /// The device is one of that profile, and is measured anew. A simulated device ignores it.
    virtual void choose_kind(const std::string& /*profile*/) {}

    /// As BlackBox::hold(): the last minute stays in memory.
    virtual void hold_recording() = 0;

    /// Writes the last minute to a file, only for the operator; a notice says where.
    virtual void keep_recording() = 0;

    /// As BlackBox::forget(): the visit is over.
    virtual void forget_recording() = 0;

    /// As Servo::stop().
    virtual void stop() = 0;
};

}  // namespace touchline
