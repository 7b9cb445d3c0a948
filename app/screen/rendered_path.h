// A piece of the curve as currently rendered, in pixels.
// Threads: pure functions.
#pragma once

#include "app/screen/layout.h"
#include "haptics/curve/curve_set.h"

#include <vector>

namespace touchline {

/// The polyline of a piece at `level`, closed if the piece is. Leaves out points less than two
/// pixels from the last one kept, but never an end: nobody sees them, and a traced photograph has
/// tens of thousands. O(segments).
[[nodiscard]] std::vector<PixelPoint> rendered_path(const CurveSet& curves, int piece, double level,
                                                    const View& view);

}  // namespace touchline
