// Finds the main things of a photograph in a worker that can do nothing else.
// Threads: any, each call by itself; it waits for its worker, at most its deadline.
#pragma once

#include "app/documents/decode/page.h"
#include "app/documents/trace/joined.h"
#include "app/documents/trace/main_things.h"
#include "app/documents/trace/trace_work.h"
#include "config/types/result.h"

namespace touchline {

/// The networks for which there is memory: without the figure's if less than 2 GB are free. Fails
/// if less than 400 MB are.
[[nodiscard]] Result<PictureNetworks> with_room(PictureNetworks networks);

/// Runs the networks (app/documents/models) on a page's pixels. Fails with one line if one cannot
/// be run, or the worker does not end well. Takes some seconds.
[[nodiscard]] Result<MainThings> find_main_things(const Page& page,
                                                  const PictureNetworks& networks);

/// The same for the thing at a place.
[[nodiscard]] Result<MainThings> find_thing_at(const PlaceInPicture& place, const Page& page,
                                               const PictureNetworks& networks);

/// Adds a photograph's main things, if they are sure, and its faces to the page as figures. Each is
/// a view by itself (page_views.h): the things, with a margin, the largest first, then the faces. A
/// face that shows most of a thing takes the thing's place. O(pixels of the mask).
[[nodiscard]] Page with_main_things(Page page, MainThings things);

/// Adds a further thing as the last view before the whole. O(pixels of the mask).
[[nodiscard]] Page with_further_thing(Page page, MainThings thing);

}  // namespace touchline
