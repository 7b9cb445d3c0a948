#include "app/trace/place_in_picture.h"

#include <charconv>
#include <system_error>

#include <fmt/format.h>

namespace touchline {
namespace {

std::optional<double> share_of(const std::string& word) {
    double share = 0.0;
    const char* const end = word.data() + word.size();
    const auto read = std::from_chars(word.data(), end, share);
    const bool is_share = read.ec == std::errc() && read.ptr == end && share >= 0.0 && share <= 1.0;
    return is_share ? std::optional(share) : std::nullopt;
}

}  // namespace

std::vector<std::string> words_of(const PlaceInPicture& place) {
    return {fmt::format("{:.6f}", place.x), fmt::format("{:.6f}", place.y)};
}

std::optional<PlaceInPicture> place_of(const std::vector<std::string>& words) {
    if (words.size() != 2) return std::nullopt;
    const auto x = share_of(words[0]);
    const auto y = share_of(words[1]);
    return x && y ? std::optional(PlaceInPicture{*x, *y}) : std::nullopt;
}

}  // namespace touchline
