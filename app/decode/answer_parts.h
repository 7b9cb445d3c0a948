// What is in an answer of a worker, for whoever reads it without copying its pixels: pages, found
// words, and the worker that finds lines. Threads: pure functions.
#pragma once

#include "app/decode/answer_header.h"
#include "app/decode/page.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace touchline::decode {

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
