// The kiosk's side of the line between kiosk and servo process. Every new servo is told again what
// was told last. Threads: connect() and disconnect() from the guard, next_event() from any one
// thread, the rest from the main thread; each call locks for as long as it takes to copy a value.
// The guard beats without the lock.
#pragma once

#include "app/force/servo/messages.h"
#include "app/force/servo/servo_client.h"
#include "haptics/servo/exchange.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace touchline {

/// What the guard and the main thread share about one servo process.
struct Connection {
    SharedRegion region;
    Descriptor socket;
};

class ServoConnection {
  public:
    // Called by the guard.
    void connect(std::shared_ptr<const Connection> connection);
    void disconnect();
    void note(const std::string& line);
    void say(const std::string& words);

    /// True if the main thread asked for the state within the last half second.
    [[nodiscard]] bool is_kiosk_alive(std::int64_t now_ns) const;

    // Called by the main thread.
    void set(const ServoCommands& commands);
    /// Sends its map, sealed. A map that cannot be sealed becomes a notice.
    void feel(const FeltPicture& picture);
    /// `wish`: hold, keep or forget the last minute.
    void ask_recorder(MessageKind wish);
    /// The newest report, if it is sound. Without force until a servo has reported. After a servo's
    /// end the device counts as lost until words tell more or the next servo reports: a device does
    /// not work again because nobody is left to say that it does not.
    void update(ServoReport& report, std::int64_t now_ns);
    [[nodiscard]] std::optional<ContactEvent> next_event();
    [[nodiscard]] std::optional<RealTimeTier> tier() const;
    [[nodiscard]] LatenessBars lateness() const;
    [[nodiscard]] std::string take_notice();
    [[nodiscard]] std::string device_words() const;

  private:
    void send_scene();
    void add_notice(const std::string& line);

    mutable std::mutex mutex_;
    std::shared_ptr<const Connection> connection_;  // null: no servo
    ServoCommands commands_;
    Descriptor map_;
    SceneOrder order_;
    std::string gallery_file_;
    std::string notice_;
    std::string words_;
    bool has_told_ = false;   // the running servo has reported
    bool has_ended_ = false;  // a servo has ended
    std::atomic<std::int64_t> asked_ns_{0};
};

}  // namespace touchline
