// Looks at a photograph for the kiosk, with networks in their worker.
// Threads: the finder is called from any, one call at a time.
#pragma once

#include "app/loading/kiosk_stages.h"

namespace touchline {

/// Works without the figure's network if that is not installed, or if less than 2 GB of memory are
/// free. Fails if a network is damaged or its worker fails.
[[nodiscard]] ThingFinder thing_finder();

}  // namespace touchline
