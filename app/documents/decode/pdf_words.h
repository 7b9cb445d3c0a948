// Private to app/documents/decode: what a page of a PDF draws, by its interpreter: letters, images,
// and the ink of the letters; how the letters join into texts, and which of these a visitor could
// see. In pixels of the page's picture, y downwards. Threads: one document, one thread; the rest
// are pure functions.
#pragma once

#include "app/documents/decode/picture.h"
#include "app/documents/decode/readers.h"
#include "config/types/pinned.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace touchline::decode {

struct Place {
    double x = 0.0;
    double y = 0.0;
};

/// A letter where the page's program puts it, visible or not: text can be drawn invisibly, in the
/// colour of its background, or be covered.
struct DrawnLetter {
    std::string text;      // UTF-8; may be a blank; empty if the document has no text for it
    Place at;              // where it begins on its line
    Place next;            // where its successor would begin
    Place up;              // from its line to the top of a tall letter
    TextBox box;           // around its cell
    bool is_sign = false;  // it draws rather than writes: symbols, arrows, frames, rules
};

/// How much of each pixel the letters' shapes cover within their clips, 0 ... 255, visible or not.
struct LetterInk {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> cover;  // rows from the top

    /// Returns 0 outside the page.
    [[nodiscard]] int at(int x, int y) const {
        if (x < 0 || y < 0 || x >= width || y >= height) return 0;
        return cover[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x)];
    }
};

struct DrawnPage {
    std::vector<DrawnLetter> letters;  // in the order of drawing, at most 50 000
    std::vector<TextBox> images;       // likewise, at most 1000; only the parts within their clips
    LetterInk ink;
};

/// Makes poppler list the folders of its tables of East Asian letters, which cannot be listed
/// later. The tables themselves can be read later.
void prepare_pdf();

/// A document through poppler's interpreter. poppler-glib tells neither where a turned image lies,
/// nor which way letters run, nor whether they are visible.
class PdfProgram : private Pinned {
  public:
    /// The bytes must outlive it.
    explicit PdfProgram(Bytes pdf);
    ~PdfProgram();

    /// The length of the page's unit in 1/72 inch; 1 if the page does not say, or not sensibly.
    [[nodiscard]] double user_unit(int page);

    /// What the page draws at `scale` pixels per unit. Empty for a page that cannot be read;
    /// drawing the page tells why.
    [[nodiscard]] DrawnPage drawn(int page, double scale);

  private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

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

/// How visible the letters of a text are in the picture: levels from the background, 0 ... 255. 0
/// if they are covered, clipped away, or in the colour of their background. Compares the picture
/// with the letters' own shapes.
[[nodiscard]] double contrast_of(const DrawnText& text, const LetterInk& ink,
                                 const Picture& picture);

/// True if the picture shows some writing where the text is said to be. The text that a reading
/// program lays over a scan is invisible, yet its words are in the picture.
[[nodiscard]] bool looks_written(const DrawnText& text, const Picture& picture);

/// The part of a box that holds ink of letters; the whole box if it holds none.
[[nodiscard]] TextBox inked(const TextBox& box, const LetterInk& ink);

}  // namespace touchline::decode
