// What the kiosk counts, day by day: visits, pictures by kind, minutes and faults; never people,
// names or times of day. Threads: values and pure functions; the files wait for the disk.
#pragma once

#include "config/types/result.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

struct Counts {
    std::uint64_t visits = 0;
    std::uint64_t gallery_pictures = 0;
    std::uint64_t stick_pictures = 0;
    std::uint64_t camera_pictures = 0;
    std::uint64_t minutes = 0;  // total length of the visits, each rounded to minutes
    std::uint64_t faults = 0;   // how often something stopped working

    friend bool operator==(const Counts&, const Counts&) = default;
};

/// A day of the site's clock on which something was counted.
struct CountedDay {
    std::chrono::sys_days day;
    Counts counts;

    friend bool operator==(const CountedDay&, const CountedDay&) = default;
};

/// They are in the order of the days.
using CountedDays = std::vector<CountedDay>;

inline constexpr std::size_t most_counted_days = 400;

/// The counts of this day, for adding to. A new day replaces the oldest if there are
/// most_counted_days already.
[[nodiscard]] Counts& counts_on(std::chrono::sys_days day, CountedDays& days);

/// The sum of all days.
[[nodiscard]] Counts total_of(const CountedDays& days);

/// A table for a spreadsheet: a line of names, then a line for each day, which begins with it as
/// "2026-03-01".
[[nodiscard]] std::string counters_csv(const CountedDays& days);

/// Reads such a table; an empty text gives no days. Fails on anything else, with one line that
/// names file and line.
[[nodiscard]] Result<CountedDays> parse_counters(std::string_view csv, std::string_view name);

/// counters.csv beside the site's settings.
[[nodiscard]] std::filesystem::path counters_file();

/// Returns no days if the file does not exist.
[[nodiscard]] Result<CountedDays> read_counters(const std::filesystem::path& file);

/// Writes the file whole or not at all, and makes its folder.
[[nodiscard]] Result<void> keep_counters(const std::filesystem::path& file,
                                         const CountedDays& days);

}  // namespace touchline
