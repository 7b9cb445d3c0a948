// The known USB boards, and the settings of the unit with a certain serial number. The table is
// config/defaults/boards.toml; the units' settings are in a file of the same form.
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
/// wrong_socket: the right board, plugged in by the wrong one of its two USB sockets.
enum class BoardCondition : std::uint8_t { running, needs_firmware, wrong_socket };

struct BoardId {
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    BoardCondition condition = BoardCondition::running;
    bool may_probe = false;  // so often a pantograph that bytes may be sent to it unasked
    std::string name;        // for people
};

/// The settings of one unit, by its serial number.
struct UnitSettings {
    std::string serial;
    std::string profile;  // a name in haptics/pantograph/profile.h; empty: not known
    Calibration calibration;
};

struct BoardSettings {
    std::vector<BoardId> boards;
    std::vector<UnitSettings> units;
    std::string notice = {};  // one line for the operator; may be empty
};

/// Parses the text of a file; `name` is the file's, for the error. Malformed text, an unknown key
/// or a value out of range gives a one-line error with file and line number. A unit written by
/// version 0 keeps only its serial number and torque limit, and there is a notice.
[[nodiscard]] Result<BoardSettings> parse_boards(std::string_view text, std::string_view name);

/// Reads at most 1 MB.
[[nodiscard]] Result<BoardSettings> read_boards(const std::filesystem::path& file);

/// Returns text that parse_boards() reads back to the same units.
[[nodiscard]] std::string units_text(const std::vector<UnitSettings>& units);

/// Returns nothing if the serial number has no settings. Boards that report no serial number have
/// none either, because they cannot be told apart.
[[nodiscard]] inline const UnitSettings* find_unit(const BoardSettings& settings,
                                                   std::string_view serial) {
    const auto found = std::ranges::find(settings.units, serial, &UnitSettings::serial);
    return serial.empty() || found == settings.units.end() ? nullptr : &*found;
}

}  // namespace touchline
