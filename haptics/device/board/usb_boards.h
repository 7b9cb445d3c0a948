// Finds and opens boards on the USB, through libusb, and a pantograph behind one with what is known
// of the unit; programs start here. A board is named by its serial number, never by its place in a
// list. An opened board has a node: one process passes it to another, which can then turn the
// motors off without looking for the board, opening it or asking who has it.
#pragma once

#include "config/settings/boards.h"
#include "config/types/result.h"
#include "haptics/device/board/board_link.h"
#include "haptics/device/board/pantograph_board.h"
#include "haptics/pantograph/profile.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

struct libusb_context;

namespace touchline {

/// Addresses, as in the descriptors.
struct SerialPipes {
    int control_interface = 0;
    int data_interface = 1;
    std::uint8_t out_endpoint = 0;
    std::uint8_t in_endpoint = 0;
};

struct UsbNode {
    int descriptor = -1;  // owned and closed by somebody else
    SerialPipes pipes;
    std::string bus_path;  // as in FoundBoard
};

/// Ends all transfers under way, whoever began them, and sends zero torque. Returns true if all its
/// bytes went. Nobody else may drive the board by then, or their next write undoes it. The board's
/// answer is not read. Takes 20 ms at most, without a heap; 1 ms if all is well.
[[nodiscard]] bool write_zero(int descriptor, const SerialPipes& pipes,
                              const DeviceProfile& profile);

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
    explicit UsbBoards(std::shared_ptr<libusb_context> context) : context_(std::move(context)) {}

    std::shared_ptr<libusb_context> context_;
};

struct UsbPantograph {
    FoundBoard found;
    DeviceProfile profile;  // with the unit's own torque limit
    std::unique_ptr<PantographBoard> driver;
};

/// Takes the board with that serial number, or the only one if none is given. Profile and
/// calibration are the unit's in `settings`, else `profile_name` and none. Nothing has been sent to
/// the board yet: driver->open() does that, with the handle at home. Allocates and waits.
[[nodiscard]] Result<UsbPantograph> take_pantograph(const UsbBoards& usb,
                                                    const BoardSettings& settings,
                                                    std::string_view serial,
                                                    std::string_view profile_name,
                                                    const UsbLinkOptions& options = {});

}  // namespace touchline
