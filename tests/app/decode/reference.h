// Other people's decoders, to be compared with: ImageMagick, rsvg-convert, pdftoppm.
#pragma once

#include "app/decode/page.h"

#include <string>

namespace touchline {

/// The picture in a file as they show it: upright, over white, in sRGB. SVG and PDF at the size of
/// `like`. Fails with their words.
[[nodiscard]] Result<Picture> reference_picture(const std::string& path, const Page& like);

/// Of channels, 0 ... 255.
struct Difference {
    int most = 0;
    double mean = 0.0;
    bool is_comparable = false;  // the same size
};

[[nodiscard]] Difference difference(const Picture& a, const Picture& b);

/// What may differ: a codec that loses, a drawing, or neither.
struct Tolerance {
    int most = 0;
    double mean = 0.0;
};

[[nodiscard]] Tolerance tolerance_for(const std::string& path);

/// Runs a command of the shell; false unless it ended well.
[[nodiscard]] bool run_command(const std::string& command);

}  // namespace touchline
