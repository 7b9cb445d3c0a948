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
//   lines    what was found, then each chain with its points: another worker, the same program,
//            makes a map of them; the kiosk keeps them and does not look inside
//
// A text is its bytes u32 and the bytes. Little-endian, no offsets. And what else crosses between
// workers as flat bytes:
//
//   camera's frame  for the worker that makes a page of it: format u8, width i32, height i32 and
//                   bytes per row u64, then its bytes
//   grey picture    width and height (u32 each), then its bytes
//   several inputs  of one worker in one piece of memory: the size of each (u64), then one after
//                   the other
//
// Threads: pure functions.
#pragma once

#include "app/documents/decode/picture.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "vision/camera/frame.h"
#include "vision/simplify/trace.h"

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

/// The inputs of one worker; they lie elsewhere.
using ThingsInBytes = std::vector<std::span<const std::byte>>;

[[nodiscard]] std::vector<std::byte> joined(const ThingsInBytes& things);

/// Separates them again; empty if there are not so many, or their sizes do not fill the memory.
[[nodiscard]] ThingsInBytes parted(std::span<const std::byte> all, std::size_t count);

[[nodiscard]] std::vector<std::byte> bytes_of(const CameraFrame& frame);

/// Fails for an unknown format, for a size beyond app/documents/decode/picture.h, and for a row
/// that is longer than all the bytes.
[[nodiscard]] Result<CameraFrame> frame_of(std::span<const std::byte> bytes);

[[nodiscard]] std::vector<std::byte> bytes_of(const GreyPicture& picture);

/// Fails unless the size is valid for a picture and fits the bytes.
[[nodiscard]] Result<GreyPicture> grey_of(std::span<const std::byte> bytes);

/// Holds what trace_lines() needs, and the report; leaves out the edges' strengths and the features
/// of the class. O(points).
[[nodiscard]] std::vector<std::byte> bytes_of(const Found& found);

/// Restores what bytes_of() got, bit for bit. Fails unless the sizes add up, every number is finite
/// and no size of a picture is empty. O(points).
[[nodiscard]] Result<Found> found_of(std::span<const std::byte> bytes);

}  // namespace touchline
