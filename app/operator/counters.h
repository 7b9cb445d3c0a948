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
    std::uint64_t minutes = 0;  // total length of the visits, rounded to minutes

    friend bool operator==(const Counters&, const Counters&) = default;
};

/// Reads one "name = number" per line; an empty text gives zeros. Fails on anything else, with one
/// line that names file and line.
[[nodiscard]] Result<Counters> parse_counters(std::string_view text, std::string_view name);

[[nodiscard]] std::string counters_text(const Counters& counters);

/// counters.toml beside the site's settings.
[[nodiscard]] std::filesystem::path counters_file();

/// Returns zeros if the file does not exist.
[[nodiscard]] Result<Counters> read_counters(const std::filesystem::path& file);

/// Writes the file whole or not at all.
[[nodiscard]] Result<void> keep_counters(const std::filesystem::path& file,
                                         const Counters& counters);

}  // namespace touchline
