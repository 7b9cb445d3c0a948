// Private to app/decode: what a page of a PDF draws, as its interpreter tells it: letters, images,
// and where the letters' ink falls. Pixels of the picture that the page is drawn as, y downwards.
// Threads: one document, one thread.
#pragma once

#include "app/decode/formats.h"
#include "app/decode/text_line.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace touchline::decode {

struct Place {
    double x = 0.0;
    double y = 0.0;
};

/// One letter where the page's program puts it, painted or not: text can be drawn invisibly, in the
/// colour of its ground, or be covered.
struct DrawnLetter {
    std::string text;      // UTF-8; a blank is one too; empty where the document knows no sign
    Place at;              // where it begins on its line
    Place next;            // where its successor would begin
    Place up;              // from its line to the top of a tall letter
    TextBox box;           // around its cell
    bool is_sign = false;  // it draws rather than writes: symbols, arrows, frames, rules
};

/// How much of each pixel the letters' shapes cover within their clips, 0 ... 255, painted or not.
struct LetterInk {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> cover;  // rows from the top

    /// 0 beside the page.
    [[nodiscard]] int at(int x, int y) const {
        if (x < 0 || y < 0 || x >= width || y >= height) return 0;
        return cover[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x)];
    }
};

struct DrawnPage {
    std::vector<DrawnLetter> letters;  // in the order of drawing, at most 50 000
    std::vector<TextBox> images;       // likewise, at most 1000; what their clips leave of them
    LetterInk ink;
};

/// Has poppler look over its tables of East Asian letters, whose folders cannot be listed later;
/// the tables themselves can be read.
void prepare_pdf();

/// A document as poppler's interpreter sees it: poppler-glib says neither where a turned image
/// lies, nor which way letters run, nor whether they are painted.
class PdfProgram {
  public:
    /// The bytes must outlive it.
    explicit PdfProgram(Bytes pdf);
    ~PdfProgram();
    PdfProgram(const PdfProgram&) = delete;
    PdfProgram& operator=(const PdfProgram&) = delete;

    /// A unit of the page in 1/72 inch; 1 where the page does not say, or not sensibly.
    [[nodiscard]] double user_unit(int page);

    /// What the page draws at so many pixels a unit. Empty for a page that cannot be read: whoever
    /// draws it says why.
    [[nodiscard]] DrawnPage drawn(int page, double scale);

  private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace touchline::decode
