// The 32 bytes that begin every answer of a worker (page.h says which).
// Threads: pure functions.
#pragma once

#include "config/types/result.h"
#include "config/types/untrusted.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace touchline {

using AnswerHeaderBytes = std::array<std::byte, 32>;

/// refusal: the map's description says why. page: pixels, boxes of words, boxes of figures, and a
/// map. words: boxes and a map, of pixels that the kiosk has.
enum class AnswerKind : std::uint8_t { refusal, page, words };

struct AnswerHeader {
    AnswerKind kind = AnswerKind::page;
    std::uint32_t width = 0;  // both 0: no pixels
    std::uint32_t height = 0;
    int number = 1;
    int count = 1;
    int dpi = 0;
    int reduction = 1;         // pixels of the file per pixel here: 1, 2, 4 or 8
    std::uint16_t boxes = 0;   // of words
    std::uint8_t figures = 0;  // a box each, after those of words
    std::uint32_t map_bytes = 0;
};

/// Bytes of the pixels that follow a header; a box takes box_bytes.
[[nodiscard]] std::size_t pixel_bytes(const AnswerHeader& header);

/// Of words and figures.
[[nodiscard]] inline std::size_t all_boxes(const AnswerHeader& header) {
    return std::size_t{header.boxes} + header.figures;
}

inline constexpr std::size_t box_bytes = 8;
inline constexpr int max_pages = 50'000;
inline constexpr std::size_t max_word_boxes = 5000;
inline constexpr std::size_t max_figures = 100;

[[nodiscard]] AnswerHeaderBytes bytes_of(const AnswerHeader& header);

/// The only way into a header: fails unless every field is in its range and the whole is
/// `answer_bytes` long.
[[nodiscard]] Result<AnswerHeader> verified(const Untrusted<AnswerHeaderBytes>& header,
                                            std::size_t answer_bytes);

}  // namespace touchline
