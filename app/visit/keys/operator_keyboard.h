// A keyboard that only the operator uses: an input device of the system (evdev) that the settings
// name. Threads: one; no call waits.
#pragma once

#include "app/isolation/process/descriptor.h"
#include "config/settings/keys.h"

#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// The key of an evdev code (linux/input-event-codes.h). A key without a name gets its scancode, as
/// the window system counts.
[[nodiscard]] PhysicalKey key_of_code(std::uint16_t code);

class OperatorKeyboard {
  public:
    /// No keyboard.
    OperatorKeyboard() = default;
    /// `path`: below /dev/input; empty: none. A missing device is looked for again.
    explicit OperatorKeyboard(std::string path);

    /// The keys that went down since the last call, without repeats.
    [[nodiscard]] std::vector<PhysicalKey> take_presses();

    /// Why it cannot be read, as one line; empty if it can, or if there is none.
    [[nodiscard]] std::string problem() const;

  private:
    void open_again();

    std::string path_;
    Descriptor descriptor_;
    int error_ = 0;   // errno of the last attempt to open it
    int waited_ = 0;  // calls since the last attempt
};

}  // namespace touchline
