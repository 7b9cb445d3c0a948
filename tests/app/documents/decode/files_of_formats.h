// A small good file of every format, and decompression bombs.
#pragma once

#include "tests/app/documents/decode/encoders.h"

#include <string>
#include <vector>

namespace touchline {

struct NamedFile {
    std::string name;
    encoders::Bytes bytes;
};

/// Returns files made by the formats' own libraries and by ImageMagick.
[[nodiscard]] std::vector<NamedFile> files_of_formats();

/// Returns small files that claim to be huge.
[[nodiscard]] std::vector<NamedFile> bombs();

/// Returns a tagged PDF with a page for each text: a heading, the text and a figure with `alt`.
[[nodiscard]] encoders::Bytes tagged_pdf(const std::vector<std::string>& texts,
                                         const std::string& alt);

/// An image's place in a PDF, in points from the lower left corner.
struct DrawnImage {
    double x_pt = 0.0;
    double y_pt = 0.0;
    double width_pt = 0.0;
    double height_pt = 0.0;
};

/// Returns an untagged PDF of 600 x 800 point pages, each with these images: a dark square on
/// white.
[[nodiscard]] encoders::Bytes drawn_pdf(const std::vector<std::vector<DrawnImage>>& pages);

}  // namespace touchline
