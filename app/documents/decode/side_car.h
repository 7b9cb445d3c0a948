// The text beside a picture: NAME.txt beside NAME.png.
// Threads: pure functions.
#pragma once

#include "config/types/tactile_map.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace touchline {

/// A longer text is no description of a picture.
constexpr std::size_t max_side_car_bytes = 65'536;

/// The name of the text that describes a file and lies beside it: "boat.txt" for "boat.jpg".
[[nodiscard]] inline std::string side_car_of(std::string_view path) {
    return std::filesystem::path(path).replace_extension(".txt").string();
}

/// The first line becomes the title, the rest the description. A single line is the description.
/// Changes nothing if the file is empty, or is no text. O(bytes).
void tell(std::string_view side_car, TactileMap& told);

}  // namespace touchline
