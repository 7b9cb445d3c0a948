// Private to app/decode: whether the lines of an SVG are all that it looks like.
// Threads: pure functions.
#pragma once

#include "app/decode/svg_transform.h"
#include "config/types/map_frame.h"

#include <pugixml.hpp>

namespace touchline::decode {

/// True if nothing but strokes and fills are drawn, and no fill covers what was drawn before it.
/// A drawing in doubt is none: its pixels are looked at instead. O(elements + shapes squared), at
/// most 2000 shapes.
[[nodiscard]] bool is_line_drawing(const pugi::xml_node& root, const ViewBox& box);

}  // namespace touchline::decode
