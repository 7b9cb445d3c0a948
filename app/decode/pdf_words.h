// Private to app/decode: texts from the letters that a PDF's page draws, and which of them a
// visitor could see. Pixels of the page's picture, y downwards. Threads: pure functions.
#pragma once

#include "app/decode/pdf_drawn.h"
#include "app/decode/picture.h"

#include <span>
#include <string>
#include <vector>

namespace touchline::decode {

struct DrawnWord {
    TextBox box;                   // around the cells of its letters
    std::vector<TextBox> letters;  // around each
};

/// Words that stand close in one line.
struct DrawnText {
    std::string text;
    TextBox box;
    std::vector<DrawnWord> words;
    std::size_t letters = 0;    // without blanks
    double height_px = 0.0;     // of a letter's cell
    bool runs_upright = false;  // up or down the page
    bool is_slanted = false;    // neither along the page nor up or down
};

/// The texts, in the order of drawing; at most 2000. What draws rather than writes is in none, nor
/// what has no letter and no digit. Letters that are spaced out are one word.
[[nodiscard]] std::vector<DrawnText> texts_in(std::span<const DrawnLetter> letters);

/// How the picture shows the letters of a text.
struct Painting {
    double contrast = 0.0;  // levels from the ground, 0 ... 255; 0: they are not to be seen
};

/// Whether the letters' own shapes are there: neither covered, nor clipped away, nor in the colour
/// of what they stand on.
[[nodiscard]] Painting painting_of(const DrawnText& text, const LetterInk& ink,
                                   const Picture& picture);

/// Does the picture show some writing where the text says that it is? Of a scan the text that a
/// reading program laid over it is invisible, and what it says is there all the same.
[[nodiscard]] bool looks_written(const DrawnText& text, const Picture& picture);

/// The part of a box where the letters' ink is; the box where there is none.
[[nodiscard]] TextBox inked(const TextBox& box, const LetterInk& ink);

}  // namespace touchline::decode
