// What the kiosk counts: visits and pictures by kind, never people, names or times of day.
// Threads: values and pure functions; the files wait for the disk.
#pragma once

#include "config/types/result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace touchline {

struct Counters {
    std::uint64_t sessions = 0;
    std::uint64_t gallery_pictures = 0;
    std::uint64_t stick_pictures = 0;
    std::uint64_t camera_pictures = 0;
    std::uint64_t minutes = 0;  // of visits, rounded to whole ones

    friend bool operator==(const Counters&, const Counters&) = default;
};

/// "name = number" a line; an empty text is all zeros. Anything else: one line with file and line.
[[nodiscard]] Result<Counters> parse_counters(std::string_view text, std::string_view name);

[[nodiscard]] std::string counters_text(const Counters& counters);

/// counters.toml beside the site's settings.
[[nodiscard]] std::filesystem::path counters_file();

/// A file that is not there is all zeros.
[[nodiscard]] Result<Counters> read_counters(const std::filesystem::path& file);

/// Whole or not at all.
[[nodiscard]] Result<void> keep_counters(const std::filesystem::path& file,
                                         const Counters& counters);

}  // namespace touchline
