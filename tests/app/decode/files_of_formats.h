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

/// Where a PDF's image lies, in points from the lower left corner.
struct DrawnImage {
    double x_pt = 0.0;
    double y_pt = 0.0;
    double width_pt = 0.0;
    double height_pt = 0.0;
};

/// A PDF without tags, of pages of 600 x 800 points, each with these images: a dark square on
/// white.
[[nodiscard]] encoders::Bytes drawn_pdf(const std::vector<std::vector<DrawnImage>>& pages);

}  // namespace touchline
