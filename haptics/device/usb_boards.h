// Finds and opens boards on the USB, through libusb. A board is named by its serial number, never
// by its place in a list.
#pragma once

#include "config/settings/boards.h"
#include "config/types/result.h"
#include "haptics/device/board_link.h"
#include "haptics/device/usb_node.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// available: it can be opened. busy: another program holds it. denied: this user may not open it.
enum class BoardAccess : std::uint8_t { available, busy, denied, unknown };

struct FoundBoard {
    BoardId id;
    std::string serial;    // empty if it cannot be read
    std::string bus_path;  // "1-2.3": bus and ports; stays the same as long as the plug stays
    int device_number = 0;
    BoardAccess access = BoardAccess::unknown;
    std::string holder;  // the program that has it, if busy; empty if that cannot be seen
};

/// Describes the board in one line for a person: what it is, where it is, and what to do if it
/// cannot be used.
[[nodiscard]] std::string describe(const FoundBoard& board);

struct UsbLinkOptions {
    unsigned send_time_out_ms = 10;
};

struct OpenedBoard {
    std::unique_ptr<BoardLink> link;
    UsbNode node;  // lives as long as the link
};

/// Threads: one at a time; links opened here may outlive it. All calls allocate and wait, so keep
/// them out of the tick.
class UsbBoards {
  public:
    /// Fails if the system has no USB.
    [[nodiscard]] static Result<UsbBoards> create();

    UsbBoards(UsbBoards&&) noexcept;
    UsbBoards& operator=(UsbBoards&&) noexcept;
    UsbBoards(const UsbBoards&) = delete;
    UsbBoards& operator=(const UsbBoards&) = delete;
    ~UsbBoards();

    /// Returns every plugged board that the table knows, sorted by bus path. Running boards are
    /// opened for a moment to read the serial number and to see who may open them; nothing is sent
    /// to them.
    [[nodiscard]] std::vector<FoundBoard> list(std::span<const BoardId> known) const;

    /// Returns the running board with that serial number; without one, the only running board that
    /// may be probed. The error says what was looked for and what was found instead.
    [[nodiscard]] Result<FoundBoard> find(std::span<const BoardId> known,
                                          std::string_view serial) const;

    /// Opens a board from find() or list(). Takes the interface from the kernel's serial driver and
    /// gives it back when the link is destroyed. A board that is busy, denied or gone gives an
    /// error in words.
    [[nodiscard]] Result<OpenedBoard> open(const FoundBoard& board,
                                           const UsbLinkOptions& options = {}) const;

  private:
    struct Context;

    explicit UsbBoards(std::shared_ptr<Context> context);

    std::shared_ptr<Context> context_;
};

}  // namespace touchline
