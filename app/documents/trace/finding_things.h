// Finds the main things of a photograph in a worker that can do nothing else: what they probably
// are, its faces, and the worker's answer as bytes, which no reader trusts.
//
//   header  magic u32, is_sure u8, two f64 (FigureSigns)
//   boxes   of the main things: how many u32, then four f64 each
//   names   how many u32; each: number u32, likelihood f64, box
//   faces   how many u32; each: box, and its map (map_bytes.h) with the bytes before it u32
//   mask    a grey picture (traced.h), the rest
//
// Threads: any, each call by itself; one that finds waits for its worker, at most its deadline.
#pragma once

#include "app/documents/decode/page.h"
#include "app/documents/decode/picture.h"
#include "app/documents/models/networks.h"
#include "app/documents/trace/trace_work.h"
#include "app/documents/trace/traced.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "config/types/thing_name.h"
#include "vision/figure/figures.h"

#include <cstddef>
#include <span>
#include <vector>

namespace touchline {

/// A face drawn in lines, and the part of the picture that fills the map's area, which may reach
/// beyond the picture (can_be_shown()). Its labels are those of config/types/thing_name.h; the map
/// has no other text.
struct DrawnFace {
    ThingBox part;
    TactileMap map;
};

/// True if the part reaches into the picture, is not empty, and lies at most four pictures away.
[[nodiscard]] bool can_be_shown(const ThingBox& part);

struct MainThings {
    GreyPicture mask;             // with the picture's proportions; 128 and more: a thing
    std::vector<ThingBox> boxes;  // the largest thing first
    FigureSigns signs;
    bool is_sure = false;
    std::vector<NamedThing> names;  // the largest thing first
    std::vector<DrawnFace> faces;   // the largest first
};

/// The networks in their order among the inputs of their worker (traced.h).
inline constexpr std::size_t picture_network_count = 6;

[[nodiscard]] inline ThingsInBytes things_of(const PictureNetworks& networks) {
    return {networks.figure, networks.small_figure, networks.names,
            networks.faces,  networks.meshes,       networks.persons};
}

/// Takes the first of `things`, which must hold at least as many.
[[nodiscard]] inline PictureNetworks networks_in(const ThingsInBytes& things) {
    return {things[0], things[1], things[2], things[3], things[4], things[5]};
}

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

[[nodiscard]] MainThings main_things_of(const Figures& figures);

/// Fails as config/types/map_bytes.h for a face's map.
[[nodiscard]] Result<std::vector<std::byte>> bytes_of(const MainThings& things);

/// Fails with one line unless every size and number is in its range, and no box is empty.
[[nodiscard]] Result<MainThings> main_things_of(std::span<const std::byte> bytes);

}  // namespace touchline
