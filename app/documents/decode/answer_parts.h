// The parts of a worker's answer, read without copying its pixels: for pages, found words, and the
// worker that finds lines. Threads: pure functions.
#pragma once

#include "app/documents/decode/page.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace touchline::decode {

/// refusal: the map's description says why. page: pixels, boxes of words, boxes of figures, and a
/// map. words: boxes and a map, for pixels that the kiosk has.
enum class AnswerKind : std::uint8_t { refusal, page, words };

struct AnswerHeader {
    std::uint8_t figures = 0;  // how many: a box each, after those of words
    AnswerKind kind = AnswerKind::page;
    std::uint8_t reduction = 1;  // pixels of the file per pixel here: 1, 2, 4 or 8
    std::uint32_t width = 0;     // both 0: no pixels
    std::uint32_t height = 0;
    std::uint16_t number = 1;  // the page's number
    std::uint16_t count = 1;   // how many pages
    std::uint16_t dpi = 0;     // 0: unknown
    std::uint16_t boxes = 0;   // how many boxes of words
    std::uint32_t map_bytes = 0;
};

/// The parts of an answer that is no refusal: every box is within the picture, every text is one
/// line.
struct AnswerParts {
    AnswerHeader header;
    std::span<const std::byte> pixels;  // within the answer
    std::vector<WordBox> boxes;         // those of words, then those of figures
    TactileMap map;
};

/// The last header.figures boxes belong to figures. Fills in how many other boxes and how many
/// bytes of the map there are. Fails as bytes_of() does for the map.
[[nodiscard]] Result<std::vector<std::byte>> answer_with(AnswerHeader header,
                                                         std::span<const std::uint8_t> pixels,
                                                         std::span<const WordBox> boxes,
                                                         const TactileMap& map);

/// Makes each text of a map that is spoken or shown one line, short enough to listen to.
void clean_texts(TactileMap& map);

[[nodiscard]] Result<std::vector<std::byte>> refusal(const std::string& line);

/// Fails with the worker's line, escaped and cut, or with a line of this function. The bytes may be
/// anything; allocates no more than their number.
[[nodiscard]] Result<AnswerParts> parts_of(std::span<const std::byte> answer);

}  // namespace touchline::decode
