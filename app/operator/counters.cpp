#include "app/operator/counters.h"

#include "app/documents/decode/files.h"
#include "app/operator/settings_files.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

namespace fs = std::filesystem;

struct CounterRow {
    std::string_view name;
    std::uint64_t Counters::*count;
};

constexpr auto counter_rows = std::to_array<CounterRow>({
    {"sessions", &Counters::sessions},
    {"gallery_pictures", &Counters::gallery_pictures},
    {"stick_pictures", &Counters::stick_pictures},
    {"camera_pictures", &Counters::camera_pictures},
    {"minutes", &Counters::minutes},
});

std::string_view without_blanks(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
}

/// Reads a line. Returns what is wrong with it; empty if it is right.
std::string read_line(std::string_view line, Counters& counters) {
    const auto equals = line.find('=');
    const std::string_view name = without_blanks(line.substr(0, equals));
    const auto* const row =
        std::find_if(counter_rows.begin(), counter_rows.end(),
                     [&](const CounterRow& candidate) { return candidate.name == name; });
    if (equals == std::string_view::npos || row == counter_rows.end())
        return '\'' + std::string(name) + "' is no counter";
    const std::string_view number = without_blanks(line.substr(equals + 1));
    const auto count = number_in<std::uint64_t>(number);
    if (!count) return '\'' + std::string(name) + "' must be a whole number from 0 on";
    counters.*(row->count) = *count;
    return {};
}

}  // namespace

Result<Counters> parse_counters(std::string_view text, std::string_view name) {
    Counters counters;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = without_blanks(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.empty() || line.front() == '#') continue;
        const std::string why = read_line(line, counters);
        if (!why.empty())
            return failure(std::string(name) + ':' + std::to_string(number) + ": " + why);
    }
    return counters;
}

std::string counters_text(const Counters& counters) {
    std::string text = "# What this kiosk counted: never people, names or times.\n";
    for (const CounterRow& row : counter_rows)
        text += std::string(row.name) + " = " + std::to_string(counters.*(row.count)) + '\n';
    return text;
}

fs::path counters_file() {
    return settings_files().site.parent_path() / "counters.toml";
}

Result<Counters> read_counters(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error) && !error) return Counters{};
    return read_text(file).and_then(
        [&file](const std::string& text) { return parse_counters(text, file.string()); });
}

Result<void> keep_counters(const fs::path& file, const Counters& counters) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    return write_whole_file(file.string(), counters_text(counters));
}

}  // namespace touchline
