// The views of a page, which are felt one by one: each of its pictures, then the page as a whole;
// and pages that are maps of Touchline's own, which are felt as they are and not traced.
// Threads: pure functions.
#pragma once

#include "app/documents/decode/file_format.h"
#include "app/documents/decode/page.h"
#include "app/documents/trace/trace_work.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <functional>
#include <optional>
#include <vector>

namespace touchline {

/// The least pixels on the longer side of a view that a hand can follow; with fewer, the page is
/// drawn again.
inline constexpr int least_view_px = 600;
inline constexpr int most_view_dpi = 600;

/// The memory that the page holds: its pixels, and its worker's answer.
[[nodiscard]] std::size_t bytes_of(const Page& page);

/// True if the figures are a photograph's main things and faces.
[[nodiscard]] bool has_main_things(const Page& page);

/// The figures and the whole; 1 for a page without figures.
[[nodiscard]] int view_count(const Page& page);

/// True if a view (1 ... view_count) is a face drawn in lines.
[[nodiscard]] bool is_face(const Page& page, int view);

/// The names to tell of a view. The first view and the whole get all names of the page, at their
/// places in it. Any other view gets those whose box is about its own, as covering all of it.
[[nodiscard]] std::vector<NamedThing> names_told(const Page& page, int view);

/// The resolution for drawing this view (1 ... view_count): page.dpi if that is fine enough, 0 if
/// the page has only pixels of its own. The worker may give less.
[[nodiscard]] int dpi_for(const Page& page, int view);

/// Opens the page's file.
using PageOpener = std::function<Result<Page>(const PageOrder&)>;

/// The page drawn as finely as the view needs; nothing if it is fine enough, or if that fails.
[[nodiscard]] std::optional<Page> finer_page(const Page& page, int view, const PageOpener& open);

/// Turns a place of a view (1 ... view_count) into one of the page. `place` is in metres from the
/// middle of the view when it is felt whole. A place beyond the page gives the nearest one in it.
[[nodiscard]] PlaceInPicture place_in_page(const Page& page, int view, const Position& place);

/// The view as a page of its own: its pixels are cut out, and the words and labels on it are moved
/// along. A figure's text is its description, and its title if it is short. A part drawn in lines
/// has them as its outlines, and white where it reaches beyond the page; its pixels are only for
/// showing, at most 2000 along each side. The last view is the page itself. O(pixels).
[[nodiscard]] Page view_of(const Page& page, int view);

/// The map without its outlines above `detail`. Fails with one line if none is left.
[[nodiscard]] Result<TactileMap> shown_at(TactileMap map, int detail);

/// True if the page is such a map.
[[nodiscard]] inline bool is_own_map(const Page& page) {
    return !page.told.outlines.empty();
}

}  // namespace touchline
