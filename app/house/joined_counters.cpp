#include "app/house/joined_counters.h"

#include "app/documents/decode/one_line.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace touchline {
namespace {

namespace fs = std::filesystem;

/// Letters, digits, blanks, hyphens, underscores and dots; a letter or a digit first.
bool is_kiosk_name(std::string_view name) {
    const auto is_first = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    };
    constexpr std::size_t longest = 80;
    return !name.empty() && name.size() <= longest && is_first(name.front()) &&
           std::ranges::all_of(name, [&](char c) {
               return is_first(c) || c == ' ' || c == '-' || c == '_' || c == '.';
           });
}

void add_lines(const KioskCounts& kiosk, std::string& csv) {
    const std::string table = counters_csv(kiosk.days);
    std::string_view lines = table;
    for (bool is_first = true; !lines.empty(); is_first = false) {
        const std::string_view line = lines.substr(0, lines.find('\n') + 1);
        lines.remove_prefix(line.size());
        if (!is_first) csv += kiosk.kiosk + ',' + std::string(line);
    }
}

}  // namespace

std::string kiosk_of_file(const std::string& path) {
    const fs::path file(path);
    const std::string name = file.stem().string();
    const bool is_as_written = name == counters_file().stem() || name == "touchline-days";
    std::error_code error;
    return is_as_written ? fs::absolute(file, error).parent_path().filename().string() : name;
}

Result<std::string> joined_counters_csv(std::vector<KioskCounts> kiosks) {
    std::ranges::sort(kiosks, {}, &KioskCounts::kiosk);
    for (const KioskCounts& kiosk : kiosks)
        if (!is_kiosk_name(kiosk.kiosk))
            return failure("'" + one_line(kiosk.kiosk) +
                           "': is no name of a kiosk; rename the file with letters and digits");
    const auto twice = std::ranges::adjacent_find(kiosks, {}, &KioskCounts::kiosk);
    if (twice != kiosks.end())
        return failure("two kiosks are called '" + twice->kiosk + "'; rename one of the files");
    std::string csv = "kiosk," + counters_csv({});
    for (const KioskCounts& kiosk : kiosks) add_lines(kiosk, csv);
    return csv;
}

}  // namespace touchline
