// Any text gives a map of our own within its area and limits, or one clear line; a language changes
// only the words.
#include "app/documents/decode/map_svg.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace touchline;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto map = parse_own_map(text, Area{});
    (void)words_of_svg(text);
    (void)difficulty_of_map_svg(text);
    const auto english = parse_map_svg(text);
    const auto german = parse_map_svg(text, {"de"});
    if (english.has_value() != german.has_value()) abort();
    if (english && english->outlines.size() != german->outlines.size()) abort();
    if (!map) {
        if (map.error().line.empty() || map.error().line.find('\n') != std::string::npos) abort();
        return 0;
    }
    if (map->outlines.empty() || !(map->area.width_m <= Area{}.width_m + 1e-9)) abort();
    for (const Outline& outline : map->outlines) {
        if (outline.points.size() < 2) abort();
        for (const Position p : outline.points)
            if (!is_finite(p)) abort();
    }
    return 0;
}
