// What a file is, by its first bytes; a name says nothing.
// Threads: pure functions, O(1).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace touchline {

enum class FileFormat : std::uint8_t { unknown, png, jpeg, webp, tiff, svg };

[[nodiscard]] FileFormat format_of(std::span<const std::byte> bytes);

}  // namespace touchline
