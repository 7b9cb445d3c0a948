// Texts used in settings: hours of the day, and lists of languages.
// Threads: values and pure functions.
#pragma once

#include "config/settings/setting_rows.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

inline constexpr int minutes_a_day = 24 * 60;

/// From one minute of the day to another; past midnight if the end is before the beginning.
struct HoursOfDay {
    int begin_min = 0;            // 0 ... 1439
    int end_min = minutes_a_day;  // 1 ... 1440, never equal to the beginning

    friend bool operator==(const HoursOfDay&, const HoursOfDay&) = default;
};

/// Parses "09:00-17:00"; returns nothing for anything else.
[[nodiscard]] std::optional<HoursOfDay> hours_in(std::string_view text);

[[nodiscard]] std::string hours_text(const HoursOfDay& hours);

/// Returns whether this minute of the day, 0 ... 1439, is among them. The end is not.
[[nodiscard]] bool is_within(const HoursOfDay& hours, int minute);

/// Parses "en de fr": at least one code, at most 16, each once; returns nothing for anything else.
[[nodiscard]] std::optional<std::vector<std::string>> languages_in_text(std::string_view text);

[[nodiscard]] bool is_allowed(TextKind kind, const std::string& text);

/// Describes what may be written, in English, for files and their errors.
[[nodiscard]] std::string_view allowed_texts(TextKind kind);

}  // namespace touchline
