// One page of what a stranger brought, as it crosses from the worker that decoded it: a header of
// 32 bytes, pixels, a map. Nobody who reads it trusts it.
//
//   header  magic u32, layout u16, kind u16, width u32, height u32, number u16, count u16, dpi u16,
//           reduction u16, bytes of the map u32, CRC-32 of the 28 bytes before u32
//   pixels  3 bytes each (blue, green, red), rows from the top, no padding
//   map     config/types/map_bytes.h
//
// Little-endian. No offsets and no strides: one size fits a given header. Threads: pure functions.
#pragma once

#include "app/decode/picture.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "config/types/untrusted.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace touchline {

struct Page {
    Picture picture;  // none where the file gives outlines
    TactileMap told;  // what the file says of itself: title, description, labels, outlines
    int number = 1;   // 1 ... count
    int count = 1;
    int dpi = 0;  // 0: not known
};

inline constexpr std::uint32_t max_page_side_px = 10'000;
inline constexpr std::uint64_t max_page_pixels = std::uint64_t{40} << 20U;
inline constexpr int max_pages = 200;

/// Width and height within the two above?
[[nodiscard]] constexpr bool fits_a_page(std::uint64_t width, std::uint64_t height) {
    return width >= 1 && height >= 1 && width <= max_page_side_px && height <= max_page_side_px &&
           width * height <= max_page_pixels;
}

/// What a worker answers: a page, or one line that says why there is none.
[[nodiscard]] Result<std::vector<std::byte>> answer_of(const Result<Page>& page);

/// The page, or the worker's line, escaped and cut. Any bytes may be given; nothing is allocated
/// beyond their number. O(bytes).
[[nodiscard]] Result<Page> page_of(std::span<const std::byte> answer);

using PageHeaderBytes = std::array<std::byte, 32>;

struct PageHeader {
    bool is_refusal = false;  // the map's description says why
    std::uint32_t width = 0;  // both 0: no pixels
    std::uint32_t height = 0;
    int number = 1;
    int count = 1;
    int dpi = 0;
    int reduction = 1;  // pixels of the file per pixel here: 1, 2, 4 or 8
    std::uint32_t map_bytes = 0;
};

/// The only way into a header: fails unless every field is in its range and the whole is
/// `answer_bytes` long.
[[nodiscard]] Result<PageHeader> verified(const Untrusted<PageHeaderBytes>& header,
                                          std::size_t answer_bytes);

}  // namespace touchline
