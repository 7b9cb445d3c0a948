// What the kiosk's screen shows now. Threads: a pure function.
#pragma once

#include "app/kiosk/kiosk.h"
#include "app/screen/screen_content.h"

namespace touchline {

/// O(items of the screen).
[[nodiscard]] ScreenContent content_of(const Kiosk& kiosk);

}  // namespace touchline
