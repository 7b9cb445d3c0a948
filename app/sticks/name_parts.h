// Private to app/sticks: a name taken apart into words and numbers, and the dates that the numbers
// form. Threads: values and pure functions. O(n).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// A word (letters, with their accents and the apostrophes between them) or a run of digits.
struct NamePart {
    std::string text;  // digits of every script as ASCII
    std::string gap;   // what stands between it and the part before; blanks of all kinds as ' '
    bool is_digits = false;
};

/// No more than `most_characters` of words and digits. Bytes of no character, and
/// characters that nobody sees, part words as blanks do.
[[nodiscard]] std::vector<NamePart> parts_of_name(std::string_view name,
                                                  std::size_t most_characters);

struct ClockTime {
    int hour = 0;    // 0 ... 23
    int minute = 0;  // 0 ... 59
    int second = 0;  // 0 ... 59
};

/// A day that the calendar has, of the years 1900 to 2099, and the time of it where one follows.
struct NameMoment {
    int year = 0;
    int month = 1;
    int day = 1;
    std::optional<ClockTime> clock;
    std::size_t parts = 0;  // that it takes, from the first on
};

/// The moment that the first parts form: "20230405", "2023-04-05 at 10.15.00", "20230405_101500",
/// "05.04.2023"; in numbers alone day and month may come in either order, so two that could be
/// either are no date unless dots part them.
[[nodiscard]] std::optional<NameMoment> moment_of(std::span<const NamePart> parts);

}  // namespace touchline
