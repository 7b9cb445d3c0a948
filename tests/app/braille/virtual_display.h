// A braille display of no make: the other end of brltty's own virtual driver, which speaks lines of
// text (brltty's Drivers/Braille/Virtual/README), and the brltty that drives it.
// Threads: the test's, and one that reads.
#pragma once

#include "config/types/pinned.h"

#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include <sys/types.h>

namespace touchline {

/// Listens at a socket of the folder; brltty comes as the client.
class VirtualDisplay : private Pinned {
  public:
    VirtualDisplay(const std::filesystem::path& folder, int columns);
    ~VirtualDisplay();

    [[nodiscard]] std::string socket() const { return socket_.string(); }

    /// Presses a key: a command of brltty, such as "LnDn", "FwinRt" or "Route 3".
    void press(const std::string& command) { send(command); }

    /// What stands there, as characters of BRF, without the blanks at the end; '?' where a cell has
    /// dots 7 or 8 alone.
    [[nodiscard]] std::string shown() const;

    /// Waits until that is what stands there. Returns false after `most_s`.
    [[nodiscard]] bool shows(const std::function<bool(const std::string&)>& is_right,
                             double most_s = 15.0) const;
    [[nodiscard]] bool shows(const std::string& text, double most_s = 15.0) const;

  private:
    void run(const std::stop_token& stop);
    void take(const std::string& line);
    void send(const std::string& line);

    std::filesystem::path socket_;
    int listener_ = -1;
    int columns_;
    mutable std::mutex mutex_;
    int client_ = -1;
    std::string shown_;
    std::jthread thread_;
};

/// A brltty that serves BrlAPI to this process alone; ends with the object.
class Brltty : private Pinned {
  public:
    /// Where brltty is installed, or empty.
    [[nodiscard]] static std::string program();

    /// `host`: as of BRLAPI_HOST, such as ":4711".
    Brltty(const std::filesystem::path& folder, const std::string& host,
           const std::string& display_socket);

    ~Brltty() { stop(); }

    void stop();

  private:
    pid_t pid_ = -1;
};

}  // namespace touchline
