#include "app/device/board_files.h"

#include "app/decode/files.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

namespace touchline {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
    // Nothing in the program changes its environment.
    const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
    return value != nullptr ? value : "";
}

fs::path installed_boards() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const fs::path installed = program.parent_path() / TOUCHLINE_BOARDS_BESIDE_PROGRAM;
    if (!error && fs::is_regular_file(installed, error)) return installed.lexically_normal();
    return TOUCHLINE_BOARDS_SOURCE;
}

fs::path user_settings() {
    const std::string chosen = environment("XDG_CONFIG_HOME");
    if (!chosen.empty()) return chosen;
    const std::string home = environment("HOME");
    return home.empty() ? fs::path("/etc") : fs::path(home) / ".config";
}

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
    return {boards.empty() ? installed_boards() : fs::path(boards),
            units.empty() ? user_settings() / "touchline" / "units.toml" : fs::path(units)};
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
