// What stands around a drawing: title, "this side up", scale, and the title for eyes.
// Threads: pure functions.
#pragma once

#include "app/sheets/braille_lines.h"
#include "app/sheets/tactile_sheet.h"

#include <string>

namespace touchline {

/// The braille of a frame and its words.
struct FrameWords {
    std::string title;
    BrailleCells title_cells;  // may be empty
    std::string up;
    BrailleCells up_cells;
    std::string scale;
    BrailleCells scale_cells;
};

struct PageFrame {
    PaperPage page;
    PaperBox zone;  // for the drawing and its labels; may be empty on small paper
};

/// Title at the upper left, an arrow and its words at the upper right, below each other where the
/// title is long; a bar of 20 mm and its words at the lower left.
[[nodiscard]] PageFrame page_frame(PaperSize size, const FrameWords& words);

/// The page's area inside the margins.
[[nodiscard]] PaperBox printable(PaperSize size);

/// The title for eyes, below everything else, and the number of the page.
[[nodiscard]] SheetPrint foot_of(PaperSize size, const std::string& title, std::size_t page,
                                 std::size_t pages);

/// How high the foot is, with its distance to what is above.
inline constexpr double foot_mm = 7.0;

inline constexpr double scale_bar_mm = 20.0;

}  // namespace touchline
