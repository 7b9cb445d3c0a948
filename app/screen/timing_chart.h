// A bar chart of how late the servo's ticks began, a part of the staff's live view.
// Threads: values and pure functions; painting one at a time per Canvas.
#pragma once

#include "app/screen/layout.h"
#include "app/screen/theme.h"
#include "audio-cues/words/language.h"
#include "haptics/servo/lateness.h"

#include <cairo.h>

namespace touchline {

/// The height that the chart needs with letters of this size.
[[nodiscard]] double timing_chart_height_px(double cap_px);

/// Paints a title and a row per bar: its range, the bar, the number of ticks. Lengths grow with the
/// logarithm, so that one late tick among millions still has a bar.
void paint_timing(cairo_t* cr, const Rect& rect, const LatenessBars& bars, double cap_px,
                  const Palette& palette, const Language& language);

}  // namespace touchline
