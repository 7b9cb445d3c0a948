// From a file name to what is felt and shown.
// Threads: any, each call by itself.
#pragma once

#include "app/trace/tracing.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <string>

namespace touchline {

/// True for a name that ends in .svg, which is a map to every command but `trace`.
[[nodiscard]] bool is_map_name(const std::string& path);

/// The view number `view` (1 ..., app/trace/page_views.h) of a file's first page, as the kiosk
/// opens and draws it.
[[nodiscard]] Result<Page> open_view(const std::string& path, int view = 1);

/// What the kiosk lets a hand feel of that view: its lines; a map of Touchline's own as it is.
[[nodiscard]] Result<TracedMap> trace_picture(const std::string& path, const TraceRequest& request,
                                              int view = 1);

/// The map of a file: an .svg read as it is, another one as trace_picture() gives it by default.
/// `as_picture` makes an .svg a picture.
[[nodiscard]] Result<TactileMap> load_map(const std::string& path, bool as_picture);

/// A map, its outlines above `detail` left out.
[[nodiscard]] Result<TactileMap> load_drawing(const std::string& path, int detail);

}  // namespace touchline
