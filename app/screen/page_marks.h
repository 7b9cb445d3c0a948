// "7 of 40" and "Page 2 of 3": the place among the items and the pages.
// Threads: one at a time per Canvas.
#pragma once

#include "app/screen/text_lines.h"
#include "audio-cues/words/language.h"

#include <cstddef>
#include <string>

namespace touchline {

/// `page` counts from 0. Empty if there are fewer than two pages.
[[nodiscard]] std::string page_words(std::size_t page, std::size_t pages, const Language& language);

/// As spoken_item() says it.
[[nodiscard]] std::string place_words(std::size_t item, std::size_t items,
                                      const Language& language);

/// True if both fit side by side; otherwise they go one below the other.
[[nodiscard]] bool are_beside(cairo_t* cr, double width_px, LineStyle style,
                              const std::string& place, const std::string& page);

/// The most rows that the marks of a list of this length need.
[[nodiscard]] int rows_of_marks(cairo_t* cr, std::size_t items, double width_px, LineStyle style,
                                const Language& language);

}  // namespace touchline
