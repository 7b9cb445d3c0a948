// The letters by which people look for a name in a long list, and the order that follows from them.
// Threads: pure functions.
#pragma once

#include "app/documents/sticks/listing.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

inline constexpr std::string_view digit_letter = "0";  // stands for every digit

/// The first letter or digit of each name, in capitals: digit_letter for any digit; empty for a
/// sign of a script that has thousands, and for a name with neither. The names are files of any
/// bytes. Accents do not count, in any language: the order of a list is the same for all of them.
/// O(all names), some milliseconds for 10 000.
[[nodiscard]] std::vector<std::string> first_letters(std::span<const std::string> names);

/// Sorts names by their first letters, those with digits first and those without a letter last;
/// then in natural order (names.h). A folder counts only among files of the same name. O(n log n).
void sort_by_name(std::vector<StickEntry>& entries);

}  // namespace touchline
