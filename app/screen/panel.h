// The staff's panel beside the picture: its words, the message band, and a bar chart of how late
// the servo's ticks began. Threads: one at a time per Canvas.
#pragma once

#include "app/screen/layout.h"
#include "app/screen/theme.h"
#include "app/visit/status.h"
#include "audio-cues/words/language.h"
#include "haptics/servo/real_time.h"

#include <string>

#include <cairo.h>

namespace touchline {

/// Fills `rect` with the status, in as many columns as fit its width. Text is `cap_px` high, or
/// smaller if it would not fit: nothing is cut off. Returns the cap height used.
double paint_panel(cairo_t* cr, const Rect& rect, const Status& status, double cap_px);

/// Paints one message along the lower edge of `rect`. Returns the cap height used.
double paint_message(cairo_t* cr, const Rect& rect, const std::string& message, double cap_px);

/// The height that the chart needs with letters of this size.
[[nodiscard]] double timing_chart_height_px(double cap_px);

/// Paints a title and a row per bar: its range, the bar, the number of ticks. Lengths grow with the
/// logarithm, so that one late tick among millions still has a bar.
void paint_timing(cairo_t* cr, const Rect& rect, const LatenessBars& bars, double cap_px,
                  const Palette& palette, const Language& language);

}  // namespace touchline
