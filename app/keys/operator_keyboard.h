// A keyboard that is the operator's alone: an input device of the system (evdev) that the settings
// name. Threads: one; no call waits.
#pragma once

#include "config/settings/keys.h"

#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// The key of an evdev code (linux/input-event-codes.h); one without a name by its scancode, as the
/// window system counts them.
[[nodiscard]] PhysicalKey key_of_code(std::uint16_t code);

class OperatorKeyboard {
  public:
    /// None.
    OperatorKeyboard() = default;
    /// `path`: below /dev/input; empty: none. One that is not there yet is looked for again.
    explicit OperatorKeyboard(std::string path);
    ~OperatorKeyboard();
    OperatorKeyboard(OperatorKeyboard&& other) noexcept;
    OperatorKeyboard& operator=(OperatorKeyboard&& other) noexcept;
    OperatorKeyboard(const OperatorKeyboard&) = delete;
    OperatorKeyboard& operator=(const OperatorKeyboard&) = delete;

    /// Keys that went down since this was last asked, without repeats.
    [[nodiscard]] std::vector<PhysicalKey> take_presses();

    /// Why it cannot be read, as one line; empty where it can or there is none.
    [[nodiscard]] std::string problem() const;

  private:
    void open_again();

    std::string path_;
    int descriptor_ = -1;
    int error_ = 0;   // of the last opening
    int waited_ = 0;  // calls since it was last looked for
};

}  // namespace touchline
