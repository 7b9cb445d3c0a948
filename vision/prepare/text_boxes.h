// Finds where a page has lines of text, and what else is on it. Reading (OCR) supplies the words.
// Threads: pure functions.
#pragma once

#include "vision/prepare/paper.h"

#include <vector>

namespace touchline {

struct TextLine {
    cv::Rect box;
    int letters = 0;  // separate marks: about the number of letters
};

struct PageLayout {
    std::vector<TextLine> lines;    // from the top, then from the left
    std::vector<cv::Rect> figures;  // neither text nor specks; overlapping boxes are merged
};

/// Boxes are in pixels of the ink. A line of text is a row of at least three marks of like height
/// on one straight base line, as near to each other as letters and words are. Slant up to about 10
/// degrees. Letters need 5 pixels of height. O(pixels + marks log marks).
[[nodiscard]] PageLayout page_layout(const Ink& ink);

}  // namespace touchline
