// The main things of a photograph, found by a worker that can do nothing else.
// Threads: any, each call by itself; it waits for its worker, at most its deadline.
#pragma once

#include "app/decode/page.h"
#include "app/trace/main_things.h"
#include "app/trace/picture_networks.h"
#include "app/trace/place_in_picture.h"
#include "config/types/result.h"

namespace touchline {

/// Those for which there is memory: without the figure's where less than 2 GB are free. Fails where
/// less than 400 MB are.
[[nodiscard]] Result<PictureNetworks> with_room(PictureNetworks networks);

/// What the networks (app/models) make of a page's pixels. Fails, with one line, where one cannot
/// be run, or the worker does not end well. Some seconds.
[[nodiscard]] Result<MainThings> find_main_things(const Page& page,
                                                  const PictureNetworks& networks);

/// The same of the thing at a place.
[[nodiscard]] Result<MainThings> find_thing_at(const PlaceInPicture& place, const Page& page,
                                               const PictureNetworks& networks);

/// The page with its main things, if they are sure, and its faces as figures: each is a view by
/// itself (page_views.h), a thing with a margin, the largest first, then the faces; but a face
/// that shows most of a thing with it takes its place. O(pixels of the mask).
[[nodiscard]] Page with_main_things(Page page, MainThings things);

/// The page with a further thing, as the last view before the whole. O(pixels of the mask).
[[nodiscard]] Page with_further_thing(Page page, MainThings thing);

}  // namespace touchline
