// A closed line that comes too near to itself, as lines that do not: what is narrower than a gap
// is one line to a finger, not two. Chains here are in millimetres. Threads: pure function.
#pragma once

#include "vision/contour/chain.h"

#include <vector>

namespace touchline {

/// Which narrow places go first: parts (a comb falls into its teeth) or bays (it becomes a block).
enum class Narrow { parts, bays };

/// What the ring holds, parted: closed lines round all that is at least a gap wide, and the middle
/// lines of parts that are narrower. Bays that are narrower are filled; where parts go first they
/// get a middle line too. (Opening and closing by discs of half a gap.) Parts no deeper
/// than a gap stay as they are, so do tips and corners; such bays stay where parts go first. Closed
/// lines first, longest first; fixed points of the ring that lie on a line stay bit for bit. O(area
/// / cell^2), cells of gap / 32, at least 0.2 mm.
[[nodiscard]] std::vector<Chain> parted_where_narrow(const Chain& ring, double gap_mm,
                                                     Narrow first);

}  // namespace touchline
