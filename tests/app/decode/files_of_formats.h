// A small good file of every format, bombs, and damage that can be repeated.
#pragma once

#include "tests/app/decode/encoders.h"

#include <random>
#include <string>
#include <vector>

namespace touchline {

struct NamedFile {
    std::string name;
    encoders::Bytes bytes;
};

/// Made by the formats' own libraries and by ImageMagick.
[[nodiscard]] std::vector<NamedFile> files_of_formats();

/// Small files that claim to be huge.
[[nodiscard]] std::vector<NamedFile> bombs();

/// One to eight bytes changed, or a piece cut out, doubled or cut off.
[[nodiscard]] encoders::Bytes mutated(encoders::Bytes bytes, std::mt19937& random);

/// A PDF of one page a text, tagged: each page has a heading, the text and a figure with `alt`.
[[nodiscard]] encoders::Bytes tagged_pdf(const std::vector<std::string>& texts,
                                         const std::string& alt);

}  // namespace touchline
