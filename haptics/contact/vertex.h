// How a proxy gets round a vertex. A disc's centre moves round a convex vertex or the end of a line
// on an arc about it, between the normals of its two edges: with a radius of 1.4 F/K or more, the
// force turns there instead of jumping. At a sharp tip, tells which of the two edges is touched.
// Threads: one, the servo's. No allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/collision/touch.h"
#include "haptics/contact/proxy_state.h"
#include "haptics/contact/rendered_outlines.h"

#include <numbers>
#include <optional>

namespace touchline {

/// The longest chord of the arc walked at once, as an angle: 15 degrees, so that the chord passes
/// inside the arc by at most 1 % of the radius; 90 degrees for a radius of nanometres, where
/// nothing can be felt.
[[nodiscard]] double largest_arc_step_rad(double offset_m);

/// Returns n turned left by an angle.
[[nodiscard]] Direction turned(Direction n, double angle_rad);

/// Returns the angle in [0, 7/4 pi] from n to m, turning left (turn > 0) or right (turn < 0). A
/// larger one counts as 0: no arc is longer than half a turn, so n lies beyond its end m, where
/// touching the vertex and touching the edge are the same moment.
[[nodiscard]] double angle_between(Direction n, Direction m, double turn);

/// Where a proxy goes that slides round a vertex under the pull of the handle.
struct ArcGoal {
    enum class End { rest, edge, free } end = End::rest;
    double turn = 0.0;       // +1 left, -1 right, 0: stays
    double angle_rad = 0.0;  // still to go, >= 0
};

/// `n`: normal of the proxy now; `pull`: handle - vertex; `offset_m`: radius of the arc;
/// `to_left_rad`, `to_right_rad`: angles to the ends of the arc. The proxy rests where the force is
/// along the normal or inside the friction cone, leaves where the force becomes zero, and otherwise
/// goes on to the edge.
[[nodiscard]] ArcGoal arc_goal(Direction n, Position pull, double offset_m, double to_left_rad,
                               double to_right_rad, double friction);

/// Both edges of a sharp tip (under 25 degrees) are touched at the same moment within the tolerance
/// of a sweep. If the touched side of `segment` lies inside the tip, returns the contact with the
/// edge in front of it; else nothing. O(1).
[[nodiscard]] std::optional<Contact> contact_in_front(RenderedOutlines& outlines,
                                                      SegmentRef segment, const Touch& touch);

}  // namespace touchline
