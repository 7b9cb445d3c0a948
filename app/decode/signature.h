// Recognizes a file by its first bytes; its name tells nothing.
// Threads: pure functions, O(1).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace touchline {

/// office: a document of a word processor, in any of its forms. archive: other files packed.
enum class FileFormat : std::uint8_t {
    unknown,
    png,
    jpeg,
    webp,
    tiff,
    gif,
    bmp,
    pnm,
    heif,
    svg,
    pdf,
    office,
    archive
};

[[nodiscard]] FileFormat format_of(std::span<const std::byte> bytes);

}  // namespace touchline
