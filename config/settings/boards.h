// Which USB boards are known, and what is set for the unit with a certain serial number.
// The table is config/defaults/boards.toml; settings of units are in a file of the same form.
// Threads: values and pure functions.
#pragma once

#include "config/types/calibration.h"
#include "config/types/result.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// running: it speaks our protocol, if it is ours. needs_firmware: in its boot loader.
/// wrong_socket: the right board by the wrong one of its two USB sockets.
enum class BoardCondition : std::uint8_t { running, needs_firmware, wrong_socket };

struct BoardId {
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    BoardCondition condition = BoardCondition::running;
    bool may_probe = false;  // common enough as a pantograph to send bytes to it unasked
    std::string name;        // for people
};

/// One unit, by its serial number.
struct UnitSettings {
    std::string serial;
    std::string profile;  // a name of haptics/pantograph/profile.h; empty: nobody has said
    Calibration calibration;
};

struct BoardSettings {
    std::vector<BoardId> boards;
    std::vector<UnitSettings> units;
    std::string notice = {};  // one line for the operator; may be empty
};

/// What the text of a file holds; `name` is that file's, for the error. Malformed, an unknown key
/// or a value out of range: one line with file and line number. A unit as version 0 wrote it keeps
/// its serial number and torque limit only, and there is a notice.
[[nodiscard]] Result<BoardSettings> parse_boards(std::string_view text, std::string_view name);

/// At most 1 MB.
[[nodiscard]] Result<BoardSettings> read_boards(const std::filesystem::path& file);

/// The text that parse_boards() reads back to the same units.
[[nodiscard]] std::string units_text(const std::vector<UnitSettings>& units);

/// Nothing when the serial number has no settings. Boards that tell none have none either: they
/// cannot be told apart.
[[nodiscard]] inline const UnitSettings* find_unit(const BoardSettings& settings,
                                                   std::string_view serial) {
    const auto found = std::ranges::find(settings.units, serial, &UnitSettings::serial);
    return serial.empty() || found == settings.units.end() ? nullptr : &*found;
}

}  // namespace touchline
