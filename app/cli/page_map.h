// The lines that a page brings itself, as the map that is felt.
// Threads: pure functions.
#pragma once

#include "app/decode/page.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

namespace touchline {

/// The page's own lines, those above `detail` left out. Fails where there are none.
[[nodiscard]] Result<TactileMap> drawn_lines(const Page& page, int detail);

/// The outlines of a map that are shown at `detail`; fails where none is left.
[[nodiscard]] Result<TactileMap> shown_at(TactileMap map, int detail);

}  // namespace touchline
