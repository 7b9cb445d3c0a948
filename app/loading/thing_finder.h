// What looks at a photograph for the kiosk: networks in their worker.
// Threads: the finder is called from any, one call at a time.
#pragma once

#include "app/loading/kiosk_stages.h"

namespace touchline {

/// Without the figure's network where that is not installed, or less than 2 GB of memory are free.
/// It fails where a network is damaged or its worker fails.
[[nodiscard]] ThingFinder thing_finder();

}  // namespace touchline
