// Pictures that the program makes (edge strength, tours, screenshots), written as PNG.
// Threads: any.
#pragma once

#include "app/documents/decode/picture.h"

#include <cstdint>
#include <span>
#include <string>

namespace touchline {

/// A view of an 8-bit grey picture, rows from the top, tightly packed.
struct GreyView {
    int width = 0;
    int height = 0;
    std::span<const std::uint8_t> pixels;  // width x height
};

/// Writes the file whole or not at all (app/documents/decode/files.h). Fails if the pixels do not
/// fill width x height >= 1, or the file cannot be written. O(pixels).
[[nodiscard]] Result<void> write_png(const std::string& path, const Picture& picture);
[[nodiscard]] Result<void> write_png(const std::string& path, const GreyView& picture);

}  // namespace touchline
