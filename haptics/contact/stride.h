// How far along a row of edges the handle pulls a thin proxy without a stop. If an outline is
// rendered more finely than the hand moves, a step passes many short edges, and a look at each must
// cost only a few nanoseconds. Threads: pure functions, no allocation.
#pragma once

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
/// of up to two contact skins, both edges are alone, and the next one turns by less than 84
/// degrees; at most `most`, and not over the end of the row. No root, no division: about 40
/// operations a vertex.
[[nodiscard]] int vertices_passed(const EdgeRow& row, const CollisionTree& tree, int index,
                                  bool is_forward, const Pull& pull, int most);

/// How the centre of a proxy that keeps `skin_m` from both edges gets past a vertex.
struct Passage {
    Position leave;        // beside the vertex, as far as it goes along the first edge
    Position enter;        // where it begins to go along the next; the same at a concave vertex
    Direction normal;      // of the next edge
    double inset_m = 0.0;  // of `enter`, along the next edge from the vertex
};

/// `before`, `after`: directions of travel, turning by less than a right angle. The way over a
/// convex vertex is a chord of at most 1.4 skins; at a concave one it turns where the lines at
/// `skin_m` from the two edges cross.
[[nodiscard]] Passage passage(Position vertex, Direction before, Direction after,
                              double side_of_travel, double skin_m);

}  // namespace touchline
