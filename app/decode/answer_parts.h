// What is in an answer of a worker, for whoever reads it without copying its pixels: pages, found
// words, and the worker that finds lines. Threads: pure functions.
#pragma once

#include "app/decode/page.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace touchline::decode {

/// refusal: the map's description says why. page: pixels, boxes of words, boxes of figures, and a
/// map. words: boxes and a map, of pixels that the kiosk has.
enum class AnswerKind : std::uint8_t { refusal, page, words };

struct AnswerHeader {
    std::uint8_t figures = 0;  // a box each, after those of words
    AnswerKind kind = AnswerKind::page;
    std::uint8_t reduction = 1;  // pixels of the file per pixel here: 1, 2, 4 or 8
    std::uint32_t width = 0;     // both 0: no pixels
    std::uint32_t height = 0;
    std::uint16_t number = 1;  // of the page
    std::uint16_t count = 1;   // of pages
    std::uint16_t dpi = 0;     // 0: not known
    std::uint16_t boxes = 0;   // of words
    std::uint32_t map_bytes = 0;
};

/// Of an answer that is no refusal: every box within the picture, every text one line.
struct AnswerParts {
    AnswerHeader header;
    std::span<const std::byte> pixels;  // of the answer
    std::vector<WordBox> boxes;         // of words, then of figures
    TactileMap map;
};

/// The last header.figures of the boxes are those of figures; the counts of the others and of the
/// map's bytes are filled in. Fails as bytes_of() does for
/// the map.
[[nodiscard]] Result<std::vector<std::byte>> answer_with(AnswerHeader header,
                                                         std::span<const std::uint8_t> pixels,
                                                         std::span<const WordBox> boxes,
                                                         const TactileMap& map);

/// What is spoken and shown of a map is one line each, of a length that can be listened to.
void clean_texts(TactileMap& map);

[[nodiscard]] Result<std::vector<std::byte>> refusal(const std::string& line);

/// Fails with the worker's line, escaped and cut, or with ours. Any bytes may be given; nothing is
/// allocated beyond their number.
[[nodiscard]] Result<AnswerParts> parts_of(std::span<const std::byte> answer);

}  // namespace touchline::decode
