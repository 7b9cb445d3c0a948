// Turns a closed line that comes too near to itself into lines that do not: to a finger, a part
// narrower than a gap is one line, not two. Chains here are in millimetres. Threads: pure function.
#pragma once

#include "vision/contour/chain.h"

#include <vector>

namespace touchline {

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
