// The answer of a worker that found the lines of a picture: the map that is felt, and the lines
// themselves, which only another worker looks into. No reader trusts it.
//
//   header   magic u32, is a photo u8, width and height of the edges u32, bytes of the map and of
//            the lines u32
//   refusal  why there is no map; empty if there is one
//   warning  one sentence
//   report   JSON
//   map      config/types/map_bytes.h
//   edges    1 byte per pixel, rows from the top
//   lines    worker_values.h
//
// A text is its bytes u32 and the bytes. Little-endian, no offsets. Threads: pure functions.
#pragma once

#include "app/documents/decode/picture.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace touchline {

/// What is felt of a picture at one detail and zoom.
struct TracedMap {
    TactileMap map;
    bool is_photo = false;  // it may have a main thing
    std::string warning;    // one sentence if a visitor should expect little, else empty
    std::string report;     // what was chosen, found and left out, as JSON
    /// How strong each candidate for a line is (vision/contour/photo_lines.h), if it was asked for.
    GreyPicture edges;
};

struct Traced {
    Result<TracedMap> map;   // or one line that says why nothing is felt at this detail and zoom
    bool has_lines = false;  // for other details and zooms
};

/// `lines` may be empty. Fails as config/types/map_bytes.h for the map.
[[nodiscard]] Result<std::vector<std::byte>> bytes_of(const Result<TracedMap>& map,
                                                      std::span<const std::byte> lines);

/// The bytes may be anything: texts become harmless single lines, the report lines of text. Fails
/// with one line unless every size is in its range. Allocates no more than the bytes hold. O(bytes)
/// without those of the lines.
[[nodiscard]] Result<Traced> traced_of(std::span<const std::byte> bytes);

/// The bytes of the lines in an answer that traced_of() accepts, for the worker that gets it; empty
/// if there are none.
[[nodiscard]] std::span<const std::byte> lines_in(std::span<const std::byte> bytes);

}  // namespace touchline
