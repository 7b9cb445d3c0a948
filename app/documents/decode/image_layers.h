// Layered tactile pictures of the IMAGE project of McGill University (its Monarch client and its
// authoring tool). Each is an SVG of any size with one title. Layers are elements, mostly <g>, with
// data-image-layer. Names are aria-label, or the text of a <desc> that aria-labelledby names. Long
// descriptions are aria-description, or a <desc> that aria-describedby names.
// Threads: pure functions.
#pragma once

#include "config/types/choices.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <string>
#include <string_view>

namespace touchline {

/// True if there is a layer, or a shape that only aria-label or aria-labelledby names. False if the
/// text is no XML. O(text).
[[nodiscard]] bool has_image_layers(std::string_view text);

/// The same picture as a map SVG (map_svg.h). Every shape has its name, or else its layer's, as
/// <title>. If there is no description, the names and long descriptions of the layers become one.
/// The picture is fitted into `area` and centred, with its proportions kept, unless it is in
/// millimetres and small enough already. What a map SVG says itself stays. Fails with one line if
/// it is no SVG or has no size. O(text).
[[nodiscard]] Result<std::string> map_svg_of_image_layers(std::string_view text, const Area& area);

/// A map SVG as a layered picture in one language: with one title and description, every shape
/// named by aria-label, and one <g data-image-layer> for each detail that occurs. Read as a map SVG
/// it has the same points, bit for bit, and the same words. Fails with one line if it is no SVG.
/// O(text).
[[nodiscard]] Result<std::string> image_layers_of_map_svg(std::string_view text,
                                                          const LanguageTag& language);

}  // namespace touchline
