// Shapes one line at the scale of a detail: smooths away what is finer than a hand should meet,
// keeps the corners that make the shape, and takes it apart where it crosses itself or comes too
// near to itself: to a finger, a part narrower than a gap is one line, not two. Chains here are in
// millimetres.
// Threads: pure functions.
#pragma once

#include "vision/contour/chain.h"

#include <vector>

namespace touchline {

struct ShapingScale {
    double step_mm = 0.25;          // between points
    double tolerance_mm = 0.0;      // Gaussian sigma along the line
    double least_feature_mm = 0.0;  // a corner is judged by the course over half of it each way
};

/// Returns the line with even points. A fixed point inside it stays, exactly, if the course over
/// half a feature before and after turns by more than 40 degrees and no sharper one is nearer than
/// a quarter of a feature; between two of them the line is smoothed. Ends stay. Smooth curves stay
/// smooth: a circle of radius R shrinks by tolerance^2 / 2R. O(points x tolerance / step).
[[nodiscard]] Chain shaped(const Chain& line, const ShapingScale& scale);

/// Returns the line as parts that do not cross themselves: each loop that a crossing closes becomes
/// a closed line of its own (with a fixed point where it was cut off), and the rest goes on through
/// the crossing. Drops parts of crossing lines shorter than `least_mm`; perhaps none is left.
/// O(points) per cut.
[[nodiscard]] std::vector<Chain> without_self_crossings(const Chain& line, double least_mm);

/// Returns whether the line will cross itself once its points are on the grid of a map: a line that
/// leads back along itself may do so only there. False if it only touches itself. O(points).
[[nodiscard]] bool crosses_itself_in_map(const Chain& line);

/// Returns the line as parts that do not cross themselves there. O(points) per cut.
[[nodiscard]] std::vector<Chain> without_crossings_in_map(const Chain& line);

/// Which narrow places are separated first: parts (a comb falls into its teeth) or bays (it becomes
/// a block).
enum class Narrow { parts, bays };

/// Splits what the ring holds: returns closed lines round everything that is at least a gap wide,
/// and the middle lines of narrower parts. Narrower bays are filled; if parts go first, they get a
/// middle line too. (Opening and closing by discs of half a gap.) Parts no deeper than a gap stay
/// as they are, as do tips and corners; if parts go first, such bays stay too. Closed lines come
/// first, longest first; fixed points of the ring that lie on a line stay bit for bit. O(area /
/// cell^2), cells of gap / 32, at least 0.2 mm.
[[nodiscard]] std::vector<Chain> parted_where_narrow(const Chain& ring, double gap_mm,
                                                     Narrow first);

}  // namespace touchline
