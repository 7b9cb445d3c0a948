#include "app/device/board_files.h"

#include "app/decode/files.h"
#include "app/process/places.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

namespace touchline {
namespace {

namespace fs = std::filesystem;

Result<std::vector<UnitSettings>> read_units(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error) && !error) return std::vector<UnitSettings>{};
    auto settings = read_boards(file);
    if (!settings) return tl::unexpected(settings.error());
    return std::move(settings->units);
}

void put(std::vector<UnitSettings>& units, const UnitSettings& unit) {
    const auto known = std::find_if(units.begin(), units.end(),
                                    [&](const auto& u) { return u.serial == unit.serial; });
    if (known == units.end()) {
        units.push_back(unit);
    } else {
        *known = unit;
    }
}

}  // namespace

BoardFiles board_files() {
    const std::string boards = environment("TOUCHLINE_BOARDS");
    const std::string units = environment("TOUCHLINE_UNITS");
    return {boards.empty() ? installed_or(TOUCHLINE_BOARDS_BESIDE_PROGRAM, TOUCHLINE_BOARDS_SOURCE)
                           : fs::path(boards),
            units.empty() ? settings_folder() / "units.toml" : fs::path(units)};
}

Result<BoardSettings> read_board_files(const BoardFiles& files) {
    auto settings = read_boards(files.boards);
    if (!settings) return settings;
    const auto units = read_units(files.units);
    if (!units) return tl::unexpected(units.error());
    for (const UnitSettings& unit : *units) put(settings->units, unit);
    return settings;
}

Result<void> keep_unit(const BoardFiles& files, const UnitSettings& unit) {
    auto units = read_units(files.units);
    if (!units) return tl::unexpected(units.error());
    put(*units, unit);
    std::error_code error;
    fs::create_directories(files.units.parent_path(), error);
    if (error) {
        return failure("the folder " + files.units.parent_path().string() +
                       " cannot be made: " + error.message());
    }
    return write_whole_file(files.units.string(), units_text(*units));
}

}  // namespace touchline
