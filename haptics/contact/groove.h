// Forces that hold the hand at a line (groove, stay) or push it away (ridge), on the same rendered
// curve as the wall. Threads: one, the servo's. No allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/collision/scene.h"
#include "haptics/contact/proxy_state.h"

namespace touchline {

/// The attachment: the point of the curve that the hand is tied to. piece -1: none.
struct GrooveState {
    SegmentRef segment;
    double parameter = 0.0;
};

struct GrooveForce {
    Force force;
    Position attachment;  // the handle itself where there is none
    double distance_m = 0.0;
    Side side = Side::left;   // of the outline, where the handle is
    int boxes = 0;            // opened
    bool is_complete = true;  // false: the budget ended before all nearer lines were looked at
};

/// Moves the attachment along the curve to the point nearest to the handle (at most 256 walks), or
/// to another line that is nearer by a margin of 0.2 mm (so the energy never rises at the change),
/// and gives the force. d: distance, w: capture width:
///   groove  K d (1 - (d/w)^2)^2 towards the attachment (architecture section 5)
///   ridge   the same, away from it
///   stay    K d (1 - (d/w)^8) towards it: stiff nearly to the edge, so that leaving takes a push
/// 0 beyond w, where the attachment is given up. All are gradients: no loop gains energy while
/// attached.
[[nodiscard]] GrooveForce groove_step(const Scene& scene, double level, Position handle,
                                      const ContactSettings& settings, const Budget& budget,
                                      GrooveState& state);

}  // namespace touchline
