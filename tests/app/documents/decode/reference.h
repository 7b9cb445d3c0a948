// Other decoders to compare with: ImageMagick, rsvg-convert, pdftoppm.
#pragma once

#include "app/documents/decode/page.h"

#include <string>

namespace touchline {

/// Returns a file's picture as they show it: upright, over white, in sRGB. SVG and PDF have the
/// size of `like`. Fails, with one line, if they show nothing.
[[nodiscard]] Result<Picture> reference_picture(const std::string& path, const Page& like);

/// Differences of channels, 0 ... 255.
struct Difference {
    int most = 0;
    double mean = 0.0;
    bool is_comparable = false;  // the sizes are equal
};

[[nodiscard]] Difference difference(const Picture& a, const Picture& b);

/// The allowed difference: for a lossy codec, a drawing, or neither.
struct Tolerance {
    int most = 0;
    double mean = 0.0;
};

[[nodiscard]] Tolerance tolerance_for(const std::string& path);

/// Runs a shell command; returns false unless it succeeds.
[[nodiscard]] bool run_command(const std::string& command);

}  // namespace touchline
