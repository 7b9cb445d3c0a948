// Random PDF pages; the generator's own numbers tell what is painted on them.
// Threads: pure functions.
#pragma once

#include "tests/app/drawings/paint.h"

namespace touchline::testing {

/// Returns how many pages are needed for every kind of figure.
[[nodiscard]] int pdf_page_count();

/// Returns a page of six figures side by side, whose kinds follow each other from page to page; the
/// same for the same number.
[[nodiscard]] Drawing pdf_page(int number);

/// Returns what the drawing paints as a PDF page, with or without a caption.
[[nodiscard]] Drawing as_pdf(const Drawing& drawing, int seed);

}  // namespace touchline::testing
