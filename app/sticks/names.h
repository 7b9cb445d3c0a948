// The names of a stick's files, which are untrusted: any bytes except NUL and '/'. Show or say only
// the results of these functions and of spoken_name.h; open the file only by the bytes themselves.
// Threads: pure functions. O(n).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace touchline {

inline constexpr std::size_t shown_columns = 80;

/// For the screen: valid UTF-8 on one line, at most shown_columns wide (a wide character counts
/// two), with an ellipsis where it was cut. Characters that are invisible or turn the text around
/// (control, format and unassigned characters) become U+FFFD, a stray byte becomes \xNN, and a
/// letter keeps at most three accents.
[[nodiscard]] std::string shown_name(std::string_view name);

}  // namespace touchline
