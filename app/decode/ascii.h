// Private to app/decode: ASCII letters. Other bytes stay as they are, whatever the locale.
// Threads: pure function.
#pragma once

#include <string>
#include <string_view>

namespace touchline::decode {

/// The text in lower case. O(n).
[[nodiscard]] inline std::string lower(std::string_view text) {
    std::string made(text);
    for (char& c : made)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return made;
}

}  // namespace touchline::decode
