// One page of an untrusted file, as the worker that decoded it hands it over: a header of 28 bytes,
// pixels, boxes of words and figures, a map. No reader trusts it.
//
//   header  magic u32, layout u8, figures u8, kind u8, reduction u8, width u32, height u32,
//           number u16, count u16, dpi u16, boxes u16, bytes of the map u32
//   pixels  3 bytes each (blue, green, red), rows from the top, no padding; none if the kind is
//           "words" (found_words.h): the kiosk has them
//   boxes   4 u16 each: left, top, right, bottom in pixels, the right and lower end not included;
//           `boxes` of words, then one per figure
//   map     config/types/map_bytes.h; its first labels are the figures' texts
//
// Little-endian. No offsets and no strides: one size fits a given header. Threads: pure functions.
#pragma once

#include "app/documents/decode/picture.h"
#include "app/isolation/process/descriptor.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "config/types/thing_name.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace touchline {

inline constexpr int max_pages = 50'000;
inline constexpr std::size_t max_word_boxes = 5000;
inline constexpr std::size_t max_figures = 100;

/// Pixels that show words or a figure, from (left, top) up to, but without, (right, bottom).
struct WordBox {
    std::uint16_t left = 0;
    std::uint16_t top = 0;
    std::uint16_t right = 0;   // > left, within the picture
    std::uint16_t bottom = 0;  // > top

    friend bool operator==(const WordBox&, const WordBox&) = default;
};

/// A part of a page that was drawn in lines, which are felt as they are: a face.
struct DrawnPart {
    int left_px = 0;  // in the page's pixels; may lie outside the page
    int top_px = 0;
    int right_px = 0;  // > left_px
    int bottom_px = 0;
    TactileMap map;  // its area is that part
};

/// A picture on a page that holds other things too, or a thing in a photograph.
struct Figure {
    WordBox box;
    std::string text;  // its author's text for people who cannot see it; may be empty
    std::shared_ptr<const DrawnPart> drawn = {};  // null: its lines come from the pixels

    friend bool operator==(const Figure&, const Figure&) = default;
};

struct Page {
    Picture picture;
    /// What the file says about itself: title, description, labels; outlines if it is a line
    /// drawing. Its area has the picture's proportions.
    TactileMap told;
    std::vector<WordBox> words;   // not to be felt as lines
    std::vector<Figure> figures;  // in reading order
    int number = 1;               // 1 ... count
    int count = 1;
    int dpi = 0;  // 0: unknown
    /// The main things of a photograph, once they were found: values of 128 and more mark them.
    /// Covers the whole page, in fewer pixels than the page has.
    GreyPicture main_things = {};
    std::vector<NamedThing> names = {};  // what the things of a photograph probably are
    bool was_searched = false;           // for main things of every kind, not only for people
    /// The sealed answer of the worker that made this page, for the worker that finds its lines.
    /// Null if the page was made in another way, or its pixels or words have changed since.
    std::shared_ptr<const Descriptor> answer;
};

/// The answer of a worker: a page, or one line that says why there is none.
[[nodiscard]] Result<std::vector<std::byte>> answer_of(const Result<Page>& page);

/// The answer for a page that is only a picture; the worker that reads words gets it.
[[nodiscard]] Result<std::vector<std::byte>> answer_of(const Picture& picture);

/// Returns the page, or fails with the worker's line, escaped and cut. The bytes may be anything;
/// allocates no more than their number. O(bytes).
[[nodiscard]] Result<Page> page_of(std::span<const std::byte> answer);

}  // namespace touchline

/// The parts of an answer, read without copying its pixels: for pages, found words, and the worker
/// that finds lines.
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
