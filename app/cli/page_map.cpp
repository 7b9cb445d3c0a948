#include "app/cli/page_map.h"

#include <fmt/core.h>

namespace touchline {

Result<TactileMap> shown_at(TactileMap map, int detail) {
    std::erase_if(map.outlines,
                  [detail](const Outline& outline) { return outline.detail > detail; });
    if (map.outlines.empty())
        return failure(
            fmt::format("no outline is shown at detail {}; choose a higher detail", detail));
    return map;
}

Result<TactileMap> drawn_lines(const Page& page, int detail) {
    if (page.told.outlines.empty()) return failure("the picture has no lines of its own");
    return shown_at(page.told, detail);
}

}  // namespace touchline
