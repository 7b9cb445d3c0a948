// Names of files as a stick holds them, untrusted: any bytes but NUL and '/'. Only what comes out
// of these functions and of spoken_name.h is shown or said; only the bytes themselves open
// the file again.
// Threads: pure functions. O(n).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace touchline {

inline constexpr std::size_t shown_columns = 80;

/// For the screen: sound UTF-8 on one line, at most shown_columns wide (a wide character counts
/// two), with an ellipsis where it was cut. What nobody sees or what turns the text around
/// (control, format and unassigned characters) becomes U+FFFD, a byte of no character \xNN; at most
/// three accents are piled on one letter.
[[nodiscard]] std::string shown_name(std::string_view name);

}  // namespace touchline
