#include "app/trace/own_map.h"

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

}  // namespace touchline
