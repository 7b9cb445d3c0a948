// Layered tactile pictures as the IMAGE project of McGill University has them (its Monarch client
// and its authoring tool): an SVG of any size with one title; layers are elements, mostly <g>, with
// data-image-layer; names are aria-label, or the text of a <desc> that aria-labelledby names; long
// descriptions are aria-description, or a <desc> that aria-describedby names.
// Threads: pure functions.
#pragma once

#include "config/types/language_tag.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <string>
#include <string_view>

namespace touchline {

/// Is there a layer, or a shape that only aria-label or aria-labelledby names? False for what is no
/// XML. O(text).
[[nodiscard]] bool has_image_layers(std::string_view text);

/// The same picture as a map SVG (map_svg.h): every shape has its name, else its layer's, as
/// <title>; the names and long descriptions of the layers become the description where there is
/// none; fitted in `area`, centred, proportions kept, unless it is in millimetres of no larger size
/// already. What a map SVG says itself stays. Fails with one line for what is no SVG or has no
/// size. O(text).
[[nodiscard]] Result<std::string> map_svg_of_image_layers(std::string_view text, const Area& area);

/// A map SVG as a layered picture in one language: its one title and description, every shape named
/// by aria-label, and one <g data-image-layer> for each detail that is there. Read as a map SVG it
/// has the same points bit for bit and the same words. Fails with one line for what is no SVG.
/// O(text).
[[nodiscard]] Result<std::string> image_layers_of_map_svg(std::string_view text,
                                                          const LanguageTag& language);

}  // namespace touchline
