// Finds when a moving disc touches one segment: the leaf test of the collision tree, also used
// alone if the segment is known. Threads: pure functions, no allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/curve/curve_set.h"

#include <optional>

namespace touchline {

/// The proxy keeps at least this distance from every line, so that rounding (about 1e-17 m here)
/// never puts it on the wrong side and exact predicates on the printed numbers agree. 10 pm x 500
/// N/m = 5 nN.
inline constexpr double contact_skin_m = 1e-11;

/// A motion that comes less than this nearer to a line does not approach it: sliding along a line
/// must not be stopped by that line's own continuation.
inline constexpr double approach_tolerance_m = 1e-13;

struct Touch {
    double fraction = 0.0;    // of the motion, 0 ... 1
    double parameter = 0.0;   // of the point touched, on the segment, 0 ... 1
    Direction normal;         // from the point touched to the disc's centre
    double distance_m = 0.0;  // of the centre from the point touched
    bool is_end = false;      // an end of the segment is touched, not its side
};

/// Returns the first moment at which a disc of `radius_m` >= contact_skin_m moving from `from` to
/// `to` comes as near to the segment as its radius, or as its distance at the start if that is
/// less. Returns nothing if it does not come nearer by more than the tolerance. Radius 0 means a
/// point: the first point of the way on the segment, including a touch at the start, decided
/// exactly (crossing.h).
[[nodiscard]] std::optional<Touch> touch(Position from, Position to, double radius_m,
                                         const Segment& segment);

}  // namespace touchline
