// The words of the kiosk: the panel beside the picture and the message band.
// Threads: one at a time per Canvas.
#pragma once

#include "app/screen/layout.h"
#include "app/session/status.h"

#include <string>

#include <cairo.h>

namespace touchline {

/// Fills `rect` with the status, in as many columns as fit its width. Text is `cap_px` high, or
/// smaller if it would not fit: nothing is cut off. Returns the cap height used.
double paint_panel(cairo_t* cr, const Rect& rect, const Status& status, double cap_px);

/// Paints one message along the lower edge of `rect`. Returns the cap height used.
double paint_message(cairo_t* cr, const Rect& rect, const std::string& message, double cap_px);

}  // namespace touchline
