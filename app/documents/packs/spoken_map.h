// A map with its words in several languages, as the SVG that packs hold. Threads: pure functions.
#pragma once

#include "config/types/tactile_map.h"

#include <map>
#include <string>
#include <vector>

namespace touchline {

/// The words of a map in one language; what is empty is not written in it.
struct MapWords {
    std::string language;
    std::string title;
    std::string description;
    std::vector<std::string> parts;   // one for each outline
    std::vector<std::string> labels;  // one for each label
};

/// The map as an SVG text that parse_map_svg() reads: the same points bit for bit, and in each
/// language its words. `words`: at least one; the first are written without a language, so that
/// they serve every other one. The map's own words are not written. O(points + words).
[[nodiscard]] std::string spoken_map_svg(const TactileMap& map, const std::vector<MapWords>& words);

}  // namespace touchline
