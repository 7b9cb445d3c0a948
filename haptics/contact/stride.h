// How far along a row of edges the handle pulls a thin proxy without a stop: many short edges are
// passed in a step where an outline is rendered more finely than the hand moves, and a look at each
// must cost a few nanoseconds. Threads: pure functions, no allocation.
#pragma once

#include "haptics/collision/collision_tree.h"
#include "haptics/contact/proxy_state.h"
#include "haptics/contact/rendered_outlines.h"

namespace touchline {

/// What pulls, and the side of the outline that it pulls the proxy along.
struct Pull {
    Position handle;
    Side side = Side::left;
    double friction = 0.0;  // 0 ... 1
};

/// How many vertices a proxy, a point on edge `index` of the row, is pulled over one after the
/// other: the handle's foot lies beyond the edge's end, and the handle presses on the next edge and
/// pulls along it by more than friction holds. Counted only where it is clear for any offset of up
/// to two contact skins, both edges are alone, and the next turns by less than 84 degrees; at most
/// `most`, and not over the end of the row. No root, no division: about 40 operations a vertex.
[[nodiscard]] int vertices_passed(const EdgeRow& row, const CollisionTree& tree, int index,
                                  bool is_forward, const Pull& pull, int most);

/// How the centre of a proxy that keeps `skin_m` from both edges gets past a vertex.
struct Passage {
    Position leave;        // beside the vertex, as far as it goes along the first edge
    Position enter;        // where it begins to go along the next; the same at a concave vertex
    Direction normal;      // of the next edge
    double inset_m = 0.0;  // of `enter`, along the next edge from the vertex
};

/// `before`, `after`: directions of travel, turning by less than a right angle. Over a convex
/// vertex on a chord of at most 1.4 skins; at a concave one where the two lines kept from the edges
/// cross.
[[nodiscard]] Passage passage(Position vertex, Direction before, Direction after,
                              double side_of_travel, double skin_m);

}  // namespace touchline
