// Pages of PDF made up at random, with what is painted on them known from the generator's own
// numbers. Threads: pure functions.
#pragma once

#include "tests/app/drawings/paint.h"

namespace touchline::testing {

/// So many pages have every kind of figure.
[[nodiscard]] int pdf_page_count();

/// Six figures beside each other, of kinds that follow each other from page to page; the same for
/// the same number.
[[nodiscard]] Drawing pdf_page(int number);

/// What the drawing paints, as a page of PDF with a caption or none.
[[nodiscard]] Drawing as_pdf(const Drawing& drawing, int seed);

}  // namespace touchline::testing
