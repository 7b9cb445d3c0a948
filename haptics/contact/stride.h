// If an outline is rendered more finely than the hand moves, a step passes many short edges, and a
// look at each must cost only a few nanoseconds: a stride says how far along a row of edges the
// handle pulls a thin proxy without a stop. Threads: pure functions, no allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/collision/collision_tree.h"
#include "haptics/contact/proxy_state.h"
#include "haptics/contact/rendered_outlines.h"

namespace touchline {

/// What pulls, and the side of the outline along which it pulls the proxy.
struct Pull {
    Position handle;
    Side side = Side::left;
    double friction = 0.0;  // 0 ... 1
};

/// Returns how many vertices in a row a proxy, a point on edge `index`, is pulled over. A vertex
/// counts if the handle's foot lies beyond the edge's end, and the handle presses on the next edge
/// and pulls along it by more than friction holds. It counts only if this is clear for any offset
/// of up to two contact skins and whatever single precision loses, both edges are alone, and the
/// next one turns by less than 84 degrees; at most `most`, and not over the end of the row. Four
/// vertices at a time: about 30 operations each.
[[nodiscard]] int vertices_passed(const EdgeRow& row, const CollisionTree& tree, int index,
                                  bool is_forward, const Pull& pull, int most);

}  // namespace touchline
