// Makes any text one harmless line for a terminal or a log. File names and texts from devices and
// users go through here before a line is printed. Threads: pure functions.
#pragma once

#include <string>
#include <string_view>

namespace touchline {

/// Puts a blank for every control character (newline, ESC, the 8-bit ones), separator of lines, and
/// mark that turns the direction of writing or shows nothing; and '?' for what is not UTF-8. O(n).
[[nodiscard]] std::string plain_line(std::string_view text);

}  // namespace touchline
