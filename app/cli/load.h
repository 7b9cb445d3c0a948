// From a file name to what is felt and shown.
// Threads: any, each call by itself.
#pragma once

#include "app/decode/picture.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "vision/simplify/trace.h"

#include <string>

namespace touchline {

struct LoadedPicture {
    TactileMap map;
    Picture picture;      // as shown behind the outlines
    std::string warning;  // one sentence, e.g. that outlines were cut to the budget; else empty
};

/// True for a name that ends in .svg, which is a map to every command but `trace`.
[[nodiscard]] bool is_map_name(const std::string& path);

/// Opens a picture by a worker and traces it.
[[nodiscard]] Result<Trace> trace_picture(const std::string& path, const TraceOptions& options);

/// The map of a file: read as it is, or traced with the defaults of `trace`. `as_picture` makes an
/// .svg a picture.
[[nodiscard]] Result<TactileMap> load_map(const std::string& path, bool as_picture);

/// A map, its outlines above `detail` left out.
[[nodiscard]] Result<TactileMap> load_drawing(const std::string& path, int detail);

/// A picture with what is felt of it: the lines of a file that is a line drawing (every map is
/// one), else traced. Every map loaded gets a version of its own.
[[nodiscard]] Result<LoadedPicture> load_picture(const std::string& path, int detail,
                                                 const Area& area);

}  // namespace touchline
