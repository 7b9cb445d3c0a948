// The servo as a process of its own, and the guard thread that watches it. Whatever ends the servo,
// the guard zeroes the torque by the servo's own descriptor of the board. Then it opens the device
// and has the zero confirmed before it starts another servo.
//
//   main thread   set, feel, latest, events        over the shared region and the socket
//   guard thread  starts the servo, beats, checks that it lives, zeroes, restarts
//
// Threads: as ServoClient; the guard is started and joined here.
#pragma once

#include "app/force/servo/messages.h"
#include "app/force/servo/servo_client.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// What the guard itself says as device_words(): a line that visitors and staff hear differently,
/// and two sentences of the catalogue, context "device".
inline constexpr std::string_view kind_wanted = "the kind of this handle is not chosen yet";
inline constexpr std::string_view is_starting = "One moment. The handle is being started.";

struct ServoProcessOptions {
    std::string program;                 // touchline-servo, started as a child
    std::vector<std::string> arguments;  // after the socket; they name the device
    /// Opens the device, at `bus_path` unless it is empty, writes zero torque and has it confirmed.
    /// The guard thread calls it after every unasked death of the servo; if it fails, again and
    /// again for a second.
    /// Tells whether the board counted all the time.
    std::function<Result<ZeroedBoard>(const std::string& bus_path)> zero_torque;
    /// Keeps what homing found out about the unit, and returns the arguments for the next servo.
    /// Called by the guard thread. None: nothing is kept.
    std::function<std::vector<std::string>(const Message&)> keep_home = {};
    /// A path at which systemd listens, and starts a servo for each that asks. Empty: the program
    /// runs as a child.
    std::string summons = {};
    /// Keeps the kind of device that the operator chose, and returns the arguments likewise.
    std::function<std::vector<std::string>(const std::string& profile)> keep_kind = {};
    /// As ServoClient::kind(), at the start.
    std::optional<std::string> kind = {};
    /// Writes zero torque by the servo's own node: at once when the servo was killed, and again
    /// when it is dead, before zero_torque. If there is none, or the servo shared no board,
    /// zero_torque has to do.
    std::function<bool(const HeldBoard&)> cut_torque = {};
    /// Returns the arguments of a servo that goes on where one that died left the board. The guard
    /// thread calls it, and starts that servo at once, if nothing is in doubt: the dead one had
    /// angles and no fault in its last tick, the guard has zero torque confirmed by a board that
    /// was set up all the time, and there was no other such hand-over within a minute. None: every
    /// servo homes its device.
    std::function<std::vector<std::string>(const Handover&)> hand_over = {};
};

class ServoProcess final : public ServoClient {
  public:
    /// Starts the guard, which starts the servo; waits for neither.
    explicit ServoProcess(ServoProcessOptions options);
    /// Stops the servo.
    ~ServoProcess() override;

    void set(const ServoCommands& commands) override;
    void feel(const FeltPicture& picture) override;
    [[nodiscard]] const HandState& latest() override;
    [[nodiscard]] ForceStatus force_status() override;
    [[nodiscard]] std::optional<ContactEvent> next_event() override;
    [[nodiscard]] std::optional<RealTimeTier> tier() const override;
    [[nodiscard]] LatenessBars lateness() const override;
    [[nodiscard]] std::uint64_t beats() override;
    [[nodiscard]] std::string take_notice() override;
    [[nodiscard]] std::string device_words() override;
    void home_again() override;

    [[nodiscard]] std::optional<std::string> kind() const override { return kind_; }

    void choose_kind(const std::string& profile) override;
    void hold_recording() override;
    void keep_recording() override;
    void forget_recording() override;
    /// Waits until the servo has faded out and ended, two seconds at most. Then kills it and zeroes
    /// the torque.
    void stop() override;

  private:
    class Guard;

    ServoReport report_;
    std::optional<std::string> kind_;
    std::unique_ptr<Guard> guard_;
};

}  // namespace touchline
