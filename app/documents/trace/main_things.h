// The answer of a worker that looked at a photograph: its main things, what they probably are, and
// its faces. No reader trusts it.
//
//   header  magic u32, is_sure u8, two f64 (FigureSigns)
//   boxes   of the main things: how many u32, then four f64 each
//   names   how many u32; each: number u32, likelihood f64, box
//   faces   how many u32; each: box, and its map (map_bytes.h) with the bytes before it u32
//   mask    a grey picture (worker_values.h), the rest
//
// Threads: pure functions.
#pragma once

#include "app/documents/decode/picture.h"
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

[[nodiscard]] MainThings main_things_of(const Figures& figures);

/// Fails as config/types/map_bytes.h for a face's map.
[[nodiscard]] Result<std::vector<std::byte>> bytes_of(const MainThings& things);

/// Fails with one line unless every size and number is in its range, and no box is empty.
[[nodiscard]] Result<MainThings> main_things_of(std::span<const std::byte> bytes);

}  // namespace touchline
