// Touchline's own maps, which are felt as they are and not traced.
// Threads: pure functions.
#pragma once

#include "app/decode/page.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

namespace touchline {

/// The map without its outlines above `detail`. Fails with one line if none is left.
[[nodiscard]] Result<TactileMap> shown_at(TactileMap map, int detail);

/// True if the page is such a map.
[[nodiscard]] inline bool is_own_map(const Page& page) {
    return !page.told.outlines.empty();
}

}  // namespace touchline
