// Private to app/documents/sticks: divides a name into words and numbers, and finds the dates among
// the numbers. Threads: values and pure functions. O(n).
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
    std::string gap;   // what separates it from the part before; blanks of all kinds as ' '
    bool is_digits = false;
};

/// Takes at most `most_characters` of words and digits. Stray bytes and invisible characters
/// separate words as blanks do.
[[nodiscard]] std::vector<NamePart> parts_of_name(std::string_view name,
                                                  std::size_t most_characters);

struct ClockTime {
    int hour = 0;    // 0 ... 23
    int minute = 0;  // 0 ... 59
    int second = 0;  // 0 ... 59
};

/// A valid day of the years 1900 to 2099, and the time of day if one follows.
struct NameMoment {
    int year = 0;
    int month = 1;
    int day = 1;
    std::optional<ClockTime> clock;
    std::size_t parts = 0;  // how many parts it takes, from the first on
};

/// The moment that the first parts form: "20230405", "2023-04-05 at 10.15.00", "20230405_101500",
/// "05.04.2023". In numbers alone day and month may come in either order, so if both orders are
/// possible it is no date, unless dots separate the numbers.
[[nodiscard]] std::optional<NameMoment> moment_of(std::span<const NamePart> parts);

}  // namespace touchline
