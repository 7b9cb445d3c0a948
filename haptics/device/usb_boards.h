// Boards on the USB: which are there, and opening one, through libusb. A board is named by its
// serial number, never by its place in a list.
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

/// available: it can be opened. busy: another program holds it. denied: this user may not.
enum class BoardAccess : std::uint8_t { available, busy, denied, unknown };

struct FoundBoard {
    BoardId id;
    std::string serial;    // empty when it cannot be read
    std::string bus_path;  // "1-2.3": bus and ports, the same as long as the plug stays
    int device_number = 0;
    BoardAccess access = BoardAccess::unknown;
    std::string holder;  // who has it, when busy; empty when that cannot be seen
};

/// One line for a person: what it is, where, and what to do if it cannot be used.
[[nodiscard]] std::string describe(const FoundBoard& board);

struct UsbLinkOptions {
    unsigned send_time_out_ms = 10;
};

struct OpenedBoard {
    std::unique_ptr<BoardLink> link;
    UsbNode node;  // as long as the link lives
};

/// Threads: one at a time; links opened here may outlive it. All calls allocate and wait:
/// not for the tick.
class UsbBoards {
  public:
    /// Fails when the system has no USB.
    [[nodiscard]] static Result<UsbBoards> create();

    UsbBoards(UsbBoards&&) noexcept;
    UsbBoards& operator=(UsbBoards&&) noexcept;
    UsbBoards(const UsbBoards&) = delete;
    UsbBoards& operator=(const UsbBoards&) = delete;
    ~UsbBoards();

    /// Every plugged board that the table knows, sorted by bus path. Boards that run are opened for
    /// a moment, to read the serial number and to see who may; nothing is sent to them.
    [[nodiscard]] std::vector<FoundBoard> list(std::span<const BoardId> known) const;

    /// The running board with that serial number. Without one: the only running board that may be
    /// probed. The error says what was looked for and what was found instead.
    [[nodiscard]] Result<FoundBoard> find(std::span<const BoardId> known,
                                          std::string_view serial) const;

    /// Opens what find() or list() found. Takes the interface from the kernel's serial driver and
    /// gives it back when the link goes. Busy, denied or gone: an error in words.
    [[nodiscard]] Result<OpenedBoard> open(const FoundBoard& board,
                                           const UsbLinkOptions& options = {}) const;

  private:
    struct Context;

    explicit UsbBoards(std::shared_ptr<Context> context);

    std::shared_ptr<Context> context_;
};

}  // namespace touchline
