#include "app/force/device/board_files.h"

#include "app/documents/decode/files.h"
#include "app/isolation/process/places.h"

#include <algorithm>
#include <string>
#include <system_error>

namespace touchline {
namespace {

namespace fs = std::filesystem;

Result<BoardSettings> read_units(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error) && !error) return BoardSettings{};
    return read_boards(file);
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
    return {boards.empty()
                ? installed_place(TOUCHLINE_BOARDS_BESIDE_PROGRAM, TOUCHLINE_BOARDS_SOURCE)
                : fs::path(boards),
            units.empty() ? user_settings_folder() / "touchline" / "units.toml" : fs::path(units)};
}

Result<BoardSettings> read_board_files(const BoardFiles& files) {
    auto settings = read_boards(files.boards);
    if (!settings) return settings;
    const auto units = read_units(files.units);
    if (!units) return tl::unexpected(units.error());
    for (const UnitSettings& unit : units->units) put(settings->units, unit);
    if (!units->notice.empty()) settings->notice = units->notice;
    return settings;
}

Result<void> keep_unit(const BoardFiles& files, const UnitSettings& unit) {
    if (unit.serial.empty())
        return failure(
            "the board tells no serial number: nothing is stored, its kind is asked at "
            "each start");
    auto stored = read_units(files.units);
    if (!stored) return tl::unexpected(stored.error());
    put(stored->units, unit);
    std::error_code error;
    fs::create_directories(files.units.parent_path(), error);
    if (error) {
        return failure("the folder " + files.units.parent_path().string() +
                       " cannot be made: " + error.message());
    }
    return write_whole_file(files.units.string(), units_text(stored->units));
}

UnitSettings as_kind(const UnitSettings& unit, const DeviceProfile& profile) {
    UnitSettings taken{unit.serial, std::string(profile.name), {}};
    const auto limit_Nm = unit.calibration.torque_limit_Nm;
    const bool is_same = unit.profile == profile.name;
    if (limit_Nm && (is_same || *limit_Nm <= profile.torque_limit_Nm))
        taken.calibration.torque_limit_Nm = limit_Nm;
    return taken;
}

}  // namespace touchline
