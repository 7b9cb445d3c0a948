// The main things of a photograph, found by a worker that can do nothing else.
// Threads: any, each call by itself; it waits for its worker, at most its deadline.
#pragma once

#include "app/decode/page.h"
#include "app/trace/main_things.h"
#include "app/trace/place_in_picture.h"
#include "config/types/result.h"

#include <cstddef>
#include <span>

namespace touchline {

/// What the network (app/models, "figure") makes of a page's pixels. Fails, with one line, where it
/// cannot be run, the worker does not end well, or less than 2 GB of memory are free. Some seconds.
[[nodiscard]] Result<MainThings> find_main_things(const Page& page,
                                                  std::span<const std::byte> network);

/// The same of the thing at a place.
[[nodiscard]] Result<MainThings> find_thing_at(const PlaceInPicture& place, const Page& page,
                                               std::span<const std::byte> network);

/// The page with its main things as figures: each, with a margin, is a view by itself
/// (page_views.h), the largest first. O(pixels of the mask).
[[nodiscard]] Page with_main_things(Page page, MainThings things);

/// The page with a further thing, as the last view before the whole. O(pixels of the mask).
[[nodiscard]] Page with_further_thing(Page page, MainThings thing);

}  // namespace touchline
