#include "app/decode/side_car.h"

#include "app/decode/one_line.h"
#include "config/types/utf8.h"

#include <filesystem>

namespace touchline {
namespace {

constexpr std::size_t longest_title = 200;
constexpr std::size_t longest_description = 4000;

/// A picture or program that somebody named .txt.
bool is_text(std::string_view bytes) {
    return bytes.size() <= max_side_car_bytes && bytes.find('\0') == std::string_view::npos;
}

}  // namespace

std::string side_car_of(const std::string& path) {
    return std::filesystem::path(path).replace_extension(".txt").string();
}

void tell(std::string_view bytes, TactileMap& told) {
    if (!is_text(bytes)) return;
    const std::string text = utf8_of(bytes);
    std::string_view side_car = text;
    if (side_car.starts_with("\xef\xbb\xbf")) side_car.remove_prefix(3);
    const auto first = side_car.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return;
    side_car.remove_prefix(first);
    const auto end = side_car.find('\n');
    const std::string line = one_spaced(side_car.substr(0, end), longest_description);
    const std::string rest = end == std::string_view::npos
                                 ? std::string()
                                 : one_spaced(side_car.substr(end), longest_description);
    told.description = rest.empty() ? line : rest;
    if (!rest.empty()) told.title = one_spaced(line, longest_title);
}

}  // namespace touchline
