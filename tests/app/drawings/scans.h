// Drawings as a scanner or a camera sees them: softer, shaded, noisy, on a bed.
// Threads: pure functions.
#pragma once

#include "config/types/result.h"
#include "tests/app/drawings/paint.h"
#include "tests/vision/pictures/effects.h"

namespace touchline::testing {

/// Returns the drawing printed and scanned, as a JPEG: softer, unevenly lit, noisy; different for
/// each seed. Fails with one line if the kiosk does not open the drawing.
[[nodiscard]] Result<Drawing> scanned(const Drawing& drawing, int seed);

/// Returns the drawing as pixels, as painted except for `effects`. Fails likewise.
[[nodiscard]] Result<Drawing> as_pixels(const Drawing& drawing, const Effects& effects);

/// Returns the number of ways in which a sheet can lie.
[[nodiscard]] int bed_kind_count();

/// Returns the drawing on its sheet, scanned with what lies around it; nothing around the sheet is
/// a line to be seen. kind: 0 ... count - 1, the same for the same seed. Fails likewise.
[[nodiscard]] Result<Drawing> scanned_on_bed(const Drawing& drawing, int kind, int seed);

}  // namespace touchline::testing
