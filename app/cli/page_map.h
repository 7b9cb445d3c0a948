// From a page that was opened to the map that is felt.
// Threads: pure functions.
#pragma once

#include "app/decode/page.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "vision/simplify/trace.h"

namespace touchline {

/// The lines of the page's pixels, its words left out. Errors are find_lines()'s.
[[nodiscard]] Result<Found> find_page_lines(const Page& page, const TraceOptions& options);

/// The map of lines that were found on the page; title, description and labels are the page's.
/// Errors are trace_lines()'s.
[[nodiscard]] Result<Trace> trace_page_lines(const Page& page, const Found& found,
                                             const TraceOptions& options);

/// Both.
[[nodiscard]] Result<Trace> trace_page(const Page& page, const TraceOptions& options);

/// The page's own lines, those above `detail` left out. Fails where there are none.
[[nodiscard]] Result<TactileMap> drawn_lines(const Page& page, int detail);

/// The outlines of a map that are shown at `detail`; fails where none is left.
[[nodiscard]] Result<TactileMap> shown_at(TactileMap map, int detail);

/// The picture with its words painted over in the colour around them: letters are heard, not felt.
[[nodiscard]] Picture without_words(const Page& page);

}  // namespace touchline
