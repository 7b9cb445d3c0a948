#include "app/decode/one_line.h"

#include <algorithm>

namespace touchline {
namespace {

constexpr std::size_t max_bytes = 200;

bool is_control(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f;
}

bool is_continuation(char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
}

}  // namespace

std::string one_line(std::string_view text) {
    std::size_t kept = std::min(text.size(), max_bytes);
    if (kept < text.size()) {
        while (kept > 0 && is_continuation(text[kept])) --kept;
    }
    std::string line(text.substr(0, kept));
    std::replace_if(line.begin(), line.end(), is_control, ' ');
    if (kept < text.size()) line += "...";
    return line;
}

}  // namespace touchline
