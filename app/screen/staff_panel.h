// The staff's live view beside the picture: its words, what went wrong, and a bar chart of how late
// the servo's ticks began. Threads: one at a time per Canvas.
#pragma once

#include "app/screen/layout.h"
#include "app/screen/theme.h"
#include "app/visit/status.h"
#include "audio-cues/words/language.h"
#include "haptics/servo/real_time.h"

#include <optional>

#include <cairo.h>

namespace touchline {

struct LiveContent {
    Status status;
    bool shows_boxes = false;            // over the picture
    std::optional<LatenessBars> timing;  // shown below the words, if any

    friend bool operator==(const LiveContent&, const LiveContent&) = default;
};

/// Fills `rect` with words and chart. Letters are `cap_px` high, or smaller where they would not
/// fit: nothing is cut off. Returns the cap height of the words.
double paint_live(cairo_t* cr, const Rect& rect, const LiveContent& live, double cap_px,
                  const Palette& palette, const Language& language);

/// Fills `rect` with the status, in as many columns as fit its width. Returns the cap height used.
double paint_panel(cairo_t* cr, const Rect& rect, const Status& status, double cap_px,
                   const Palette& palette);

/// The height that the chart needs with letters of this size.
[[nodiscard]] double timing_chart_height_px(double cap_px);

/// Paints a title and a row per bar: its range, the bar, the number of ticks. Lengths are to scale;
/// the least one shows that there was a tick at all.
void paint_timing(cairo_t* cr, const Rect& rect, const LatenessBars& bars, double cap_px,
                  const Palette& palette, const Language& language);

}  // namespace touchline
