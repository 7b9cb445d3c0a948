// A place in a picture, and the words by which one process tells it to another.
// Threads: values and pure functions.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// In shares of the picture's width and height from its upper left corner, 0 ... 1.
struct PlaceInPicture {
    double x = 0.5;
    double y = 0.5;

    friend bool operator==(const PlaceInPicture&, const PlaceInPicture&) = default;
};

[[nodiscard]] std::vector<std::string> words_of(const PlaceInPicture& place);

/// Nothing unless the words are two numbers from 0 to 1.
[[nodiscard]] std::optional<PlaceInPicture> place_of(const std::vector<std::string>& words);

}  // namespace touchline
