#include "app/operator/counters.h"

#include "app/operator/settings_files.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <array>
#include <optional>

namespace touchline {
namespace {

namespace fs = std::filesystem;

struct CounterRow {
    std::string_view name;
    std::uint64_t Counts::*count;
};

constexpr auto counter_rows = std::to_array<CounterRow>({
    {"visits", &Counts::visits},
    {"gallery_pictures", &Counts::gallery_pictures},
    {"stick_pictures", &Counts::stick_pictures},
    {"camera_pictures", &Counts::camera_pictures},
    {"minutes", &Counts::minutes},
    {"faults", &Counts::faults},
});

std::string names_line() {
    std::string line = "day";
    for (const CounterRow& row : counter_rows) line += ',' + std::string(row.name);
    return line;
}

std::string day_text(std::chrono::sys_days day) {
    const std::chrono::year_month_day date(day);
    const auto two_digits = [](unsigned number) {
        return (number < 10 ? "-0" : "-") + std::to_string(number);
    };
    return std::to_string(static_cast<int>(date.year())) +
           two_digits(static_cast<unsigned>(date.month())) +
           two_digits(static_cast<unsigned>(date.day()));
}

/// Takes the text up to the next `end` out of `text`, and `end` too.
std::string_view take_until(char end, std::string_view& text) {
    const std::size_t length = std::min(text.find(end), text.size());
    const std::string_view part = text.substr(0, length);
    text.remove_prefix(std::min(length + 1, text.size()));
    return part;
}

std::optional<std::chrono::sys_days> day_in(std::string_view text) {
    const auto year = number_in<int>(take_until('-', text));
    const auto month = number_in<unsigned>(take_until('-', text));
    const auto day = number_in<unsigned>(text);
    constexpr int first_year = 1000;  // of four digits
    constexpr int last_year = 9999;
    if (!year || *year < first_year || *year > last_year || !month || !day) return std::nullopt;
    const std::chrono::year_month_day date{std::chrono::year(*year), std::chrono::month(*month),
                                           std::chrono::day(*day)};
    return date.ok() ? std::optional(std::chrono::sys_days(date)) : std::nullopt;
}

std::optional<CountedDay> day_of_line(std::string_view line) {
    const auto day = day_in(take_until(',', line));
    if (!day) return std::nullopt;
    CountedDay counted{*day, {}};
    for (const CounterRow& row : counter_rows) {
        const auto count = number_in<std::uint64_t>(take_until(',', line));
        if (!count) return std::nullopt;
        counted.counts.*(row.count) = *count;
    }
    return line.empty() ? std::optional(counted) : std::nullopt;
}

}  // namespace

Counts& counts_on(std::chrono::sys_days day, CountedDays& days) {
    auto at = std::ranges::lower_bound(days, day, {}, &CountedDay::day);
    if (at != days.end() && at->day == day) return at->counts;
    if (days.size() >= most_counted_days) {
        days.erase(days.begin());
        at = std::ranges::lower_bound(days, day, {}, &CountedDay::day);
    }
    return days.insert(at, {day, {}})->counts;
}

Counts total_of(const CountedDays& days) {
    Counts total;
    for (const CountedDay& day : days)
        for (const CounterRow& row : counter_rows) total.*(row.count) += day.counts.*(row.count);
    return total;
}

std::string counters_csv(const CountedDays& days) {
    std::string csv = names_line() + '\n';
    for (const CountedDay& day : days) {
        csv += day_text(day.day);
        for (const CounterRow& row : counter_rows)
            csv += ',' + std::to_string(day.counts.*(row.count));
        csv += '\n';
    }
    return csv;
}

Result<CountedDays> parse_counters(std::string_view csv, std::string_view name) {
    CountedDays days;
    for (int number = 1; !csv.empty(); ++number) {
        const std::string_view line = take_until('\n', csv);
        const auto refused = [&](const std::string& why) {
            return failure(std::string(name) + ':' + std::to_string(number) + ": " + why);
        };
        if (number == 1) {
            if (line != names_line()) return refused("must be '" + names_line() + '\'');
            continue;
        }
        const auto day = day_of_line(line);
        if (!day)
            return refused("must be a day and its " + std::to_string(counter_rows.size()) +
                           " whole numbers");
        if (!days.empty() && day->day <= days.back().day)
            return refused("must be a later day than the line before");
        counts_on(day->day, days) = day->counts;
    }
    return days;
}

fs::path counters_file() {
    return settings_files().site.parent_path() / "counters.csv";
}

Result<CountedDays> read_counters(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error) && !error) return CountedDays{};
    return read_text(file).and_then(
        [&file](const std::string& csv) { return parse_counters(csv, file.string()); });
}

Result<void> keep_counters(const fs::path& file, const CountedDays& days) {
    return keep_text(file, counters_csv(days));
}

}  // namespace touchline
