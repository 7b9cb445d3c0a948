// The two files of boards: the table that is installed with the program, and the kiosk's own file
// of settings for each unit.
// Threads: any; calls wait for the disk.
#pragma once

#include "config/settings/boards.h"
#include "config/types/result.h"
#include "haptics/pantograph/profile.h"

#include <filesystem>

namespace touchline {

struct BoardFiles {
    std::filesystem::path boards;  // must exist
    std::filesystem::path units;   // may be missing
};

/// TOUCHLINE_BOARDS or the installed table; TOUCHLINE_UNITS or touchline/units.toml in the user's
/// folder of settings.
[[nodiscard]] BoardFiles board_files();

/// Reads both files as one; a unit of the second replaces the same unit of the first.
[[nodiscard]] Result<BoardSettings> read_board_files(const BoardFiles& files);

/// Adds the unit to the file of units, or replaces it there. The file is whole at any time. Fails
/// if the board tells no serial number, because another board could be taken for it.
[[nodiscard]] Result<void> keep_unit(const BoardFiles& files, const UnitSettings& unit);

/// The unit as one of that kind, still to be measured: drops everything that was measured. Keeps
/// the site's torque limit, unless it is above the limit of the new kind.
[[nodiscard]] UnitSettings as_kind(const UnitSettings& unit, const DeviceProfile& profile);

}  // namespace touchline
