// The two files that say which boards there are: the table that is installed with the program, and
// the kiosk's own of what is set for each unit.
// Threads: any; calls wait for the disk.
#pragma once

#include "config/settings/boards.h"
#include "config/types/result.h"
#include "haptics/pantograph/profile.h"

#include <filesystem>

namespace touchline {

struct BoardFiles {
    std::filesystem::path boards;  // must be there
    std::filesystem::path units;   // need not be
};

/// TOUCHLINE_BOARDS or the installed table; TOUCHLINE_UNITS or touchline/units.toml in the user's
/// folder of settings.
[[nodiscard]] BoardFiles board_files();

/// Both files as one; a unit of the second stands for one of the first.
[[nodiscard]] Result<BoardSettings> read_board_files(const BoardFiles& files);

/// Adds the unit to the file of units or replaces it there. The file is whole at any time. Fails
/// where the board tells no serial number: another one could be taken for it.
[[nodiscard]] Result<void> keep_unit(const BoardFiles& files, const UnitSettings& unit);

/// The unit taken for one of that kind, and to be measured: nothing that was measured counts any
/// more. The site's torque limit stays, but where it is above that of another kind.
[[nodiscard]] UnitSettings as_kind(const UnitSettings& unit, const DeviceProfile& profile);

}  // namespace touchline
