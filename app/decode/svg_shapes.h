// Private to app/decode: the drawing elements of SVG, drawn with a tracer. Threads: pure functions.
#pragma once

#include "app/decode/svg_tracer.h"
#include "config/types/result.h"

#include <optional>
#include <string_view>

#include <pugixml.hpp>

namespace touchline::decode {

/// Draws the d attribute of a path. Fails with what is wrong and where, not with a whole line,
/// because the caller knows the element's name.
[[nodiscard]] Result<void> draw_path(std::string_view d, SvgTracer& tracer);

/// Draws <path>, <polyline>, <polygon>, <line>, <rect>, <circle> or <ellipse>. Returns nothing for
/// any other element, which is left out. `name` is the element's name without its prefix.
[[nodiscard]] std::optional<Result<void>> draw_shape(const pugi::xml_node& element,
                                                     std::string_view name, SvgTracer& tracer);

}  // namespace touchline::decode
