// Private to app/decode: joins the letters that a PDF's page draws into texts, and tells which of
// them a visitor could see. In pixels of the page's picture, y downwards. Threads: pure functions.
#pragma once

#include "app/decode/pdf_drawn.h"
#include "app/decode/picture.h"

#include <span>
#include <string>
#include <vector>

namespace touchline::decode {

struct DrawnWord {
    TextBox box;                   // around the cells of its letters
    std::vector<TextBox> letters;  // one around each letter
};

/// Words that stand close in one line.
struct DrawnText {
    std::string text;
    TextBox box;
    std::vector<DrawnWord> words;
    std::size_t letters = 0;    // how many, without blanks
    double height_px = 0.0;     // the height of a letter's cell
    bool runs_upright = false;  // up or down the page
    bool is_slanted = false;    // neither along the page nor up or down
};

/// The texts, in the order of drawing; at most 2000. Leaves out signs that draw rather than write,
/// and texts without letters and digits. Spaced letters are joined into one word.
[[nodiscard]] std::vector<DrawnText> texts_in(std::span<const DrawnLetter> letters);

/// How visible the letters of a text are in the picture.
struct Painting {
    double contrast = 0.0;  // levels from the background, 0 ... 255; 0: invisible
};

/// Compares the picture with the letters' own shapes: 0 if they are covered, clipped away, or in
/// the colour of their background.
[[nodiscard]] Painting painting_of(const DrawnText& text, const LetterInk& ink,
                                   const Picture& picture);

/// True if the picture shows some writing where the text is said to be. The text that a reading
/// program lays over a scan is invisible, yet its words are in the picture.
[[nodiscard]] bool looks_written(const DrawnText& text, const Picture& picture);

/// The part of a box that holds ink of letters; the whole box if it holds none.
[[nodiscard]] TextBox inked(const TextBox& box, const LetterInk& ink);

}  // namespace touchline::decode
