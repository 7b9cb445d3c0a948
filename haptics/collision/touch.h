// Finds when a moving disc touches one segment: the leaf test of the collision tree, also used
// alone if the segment is known. A point's way is decided exactly: signs by expansion arithmetic
// after Shewchuk (1997) behind a floating-point filter. A change of level moves every segment, each
// end straight and evenly: such a wall meets a point at rest. Threads: pure functions, no
// allocation.
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
/// exactly (crossing()).
[[nodiscard]] std::optional<Touch> touch(Position from, Position to, double radius_m,
                                         const Segment& segment);

/// Returns +1 if c lies to the left of the line from a to b, -1 if to the right, 0 if on it. Exact
/// for coordinates whose products neither overflow nor underflow (1e-140 ... 1e150).
[[nodiscard]] int orientation(Position a, Position b, Position c);

/// The first common point of a way and a segment, both closed.
struct Crossing {
    double fraction = 0.0;   // of the way, to 4 ulp
    double parameter = 0.0;  // on the segment, to 4 ulp
    bool from_left = false;  // the way starts on the segment's left, or on its line
};

/// Returns nothing if they have no common point, exactly.
[[nodiscard]] std::optional<Crossing> crossing(Position from, Position to, const Segment& segment);

/// A change of the rendered level between finer + from and finer + to; weights 0 ... 1 in either
/// order. Segments are named as those of level `finer`, even if a weight is 1.
struct LevelChange {
    int finer = 0;
    double from = 0.0;
    double to = 0.0;
};

/// The first segment that reaches a place.
struct WallHit {
    bool is_hit = false;
    bool is_complete = true;  // false: the budget ended first, and nothing is known
    double share = 1.0;       // of the change
    SegmentRef segment;
    double parameter = 0.0;  // of the point that reaches it, on the segment
    bool was_left = false;   // the place lay to the left of the segment
    int boxes = 0;           // opened
};

struct WallMeeting {
    double share = 0.0;
    double parameter = 0.0;
    bool was_left = false;
};

/// Returns the first moment at which a segment whose ends move straight and evenly passes over p,
/// its ends extended by a quarter of the contact skin. Returns nothing if it only comes near.
[[nodiscard]] std::optional<WallMeeting> meeting(Position p, const Segment& from,
                                                 const Segment& to);

}  // namespace touchline
