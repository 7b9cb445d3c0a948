// The line between kiosk and servo process, on the kiosk's side: what was last told is told again
// to every servo that is started. Threads: connect() and disconnect() from the guard, next_event()
// from any one, the rest from the main thread; each call locks for as long as it takes to copy a
// value. The guard beats without it.
#pragma once

#include "app/servo/messages.h"
#include "app/servo/servo_client.h"
#include "app/servo/shared_region.h"
#include "haptics/servo/exchange.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace touchline {

/// What the guard and the main thread hold of one servo process.
struct Connection {
    SharedRegion region;
    Descriptor socket;
};

class ServoConnection {
  public:
    // The guard.
    void connect(std::shared_ptr<const Connection> connection);
    void disconnect();
    void note(const std::string& line);
    void say(const std::string& words);

    /// The main thread asked for the state within the last half second.
    [[nodiscard]] bool is_kiosk_alive(std::int64_t now_ns) const;

    // The main thread.
    void set(const ServoCommands& commands);
    /// Its map, sealed; one that cannot be is a notice.
    void feel(const FeltPicture& picture);
    /// hold, keep or forget: what is to become of the last minute.
    void ask_recorder(MessageKind wish);
    /// The newest report, if it is sound; without force while no servo has told one, and with the
    /// device lost from a servo's end until words tell more or the next one reports: nothing works
    /// again because nobody is left to say that it does not.
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
    bool has_told_ = false;   // the servo that runs, a report
    bool has_ended_ = false;  // a servo
    std::atomic<std::int64_t> asked_ns_{0};
};

}  // namespace touchline
