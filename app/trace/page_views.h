// What of a page is felt by itself: each of its pictures, then the page as a whole.
// Threads: pure functions.
#pragma once

#include "app/decode/page.h"
#include "app/decode/page_order.h"
#include "app/trace/place_in_picture.h"
#include "config/types/result.h"

#include <functional>
#include <optional>
#include <vector>

namespace touchline {

/// Pixels on the longer side of a view that a hand can follow; with fewer, the page is drawn again.
inline constexpr int least_view_px = 600;
inline constexpr int most_view_dpi = 600;

/// What the page holds of the machine's memory: its pixels, and its worker's answer.
[[nodiscard]] std::size_t bytes_of(const Page& page);

/// The figures are a photograph's main things and faces.
[[nodiscard]] bool has_main_things(const Page& page);

/// Figures and the whole; 1 for a page without figures.
[[nodiscard]] int view_count(const Page& page);

/// Whether a view (1 ... view_count) is a face that was drawn in lines.
[[nodiscard]] bool is_face(const Page& page, int view);

/// What is told of a view to be named in it: all of the page's, at their places in it, where it is
/// the first that a visitor meets or the whole; else what lies in about its box, all over it.
[[nodiscard]] std::vector<NamedThing> names_told(const Page& page, int view);

/// At which the page is to be drawn for this view (1 ... view_count): page.dpi where that is fine
/// enough, 0 where the page has pixels of its own only. The worker may give less.
[[nodiscard]] int dpi_for(const Page& page, int view);

/// Opens the file that the page is of.
using PageOpener = std::function<Result<Page>(const PageOrder&)>;

/// The page drawn as finely as the view needs; nothing where it is fine enough, or that fails.
[[nodiscard]] std::optional<Page> finer_page(const Page& page, int view, const PageOpener& open);

/// Where a place of a view (1 ... view_count), from its middle and in metres as it is felt whole,
/// lies in the page; the nearest there is where it lies beyond.
[[nodiscard]] PlaceInPicture place_in_page(const Page& page, int view, const Position& place);

/// The view as a page of its own: pixels cut out, words and labels that lie on it moved along. What
/// is written of a figure is its description, and its title where it is short. A part that was
/// drawn in lines has these as its outlines, and white where it reaches beyond the page;
/// it is shown only, and has 2000 pixels along each side at most. The last
/// view is the page as it is. O(pixels).
[[nodiscard]] Page view_of(const Page& page, int view);

}  // namespace touchline
