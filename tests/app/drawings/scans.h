// Drawings as a scanner or a camera sees them: softer, shaded, noisy, on a bed. Threads: pure
// functions.
#pragma once

#include "config/types/result.h"
#include "tests/app/drawings/paint.h"
#include "tests/vision/pictures/effects.h"

namespace touchline::testing {

/// The drawing printed and scanned: softer, unevenly lit, noisy, as a JPEG; differently for each
/// seed. Fails, with one line, where the kiosk does not open the drawing.
[[nodiscard]] Result<Drawing> scanned(const Drawing& drawing, int seed);

/// The drawing as pixels, as they are painted but for `effects`. Fails likewise.
[[nodiscard]] Result<Drawing> as_pixels(const Drawing& drawing, const Effects& effects);

/// How many ways there are for a sheet to lie.
[[nodiscard]] int bed_kind_count();

/// The drawing on its sheet, scanned with what lies around it; nothing around the sheet is a line
/// to be seen. kind: 0 ... count - 1, the same for the same seed. Fails likewise.
[[nodiscard]] Result<Drawing> scanned_on_bed(const Drawing& drawing, int kind, int seed);

}  // namespace touchline::testing
