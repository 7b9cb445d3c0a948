// What finds the main things of a photograph for the kiosk: the network "figure" in its worker.
// Threads: the finder is called from any, one call at a time.
#pragma once

#include "app/loading/kiosk_stages.h"

namespace touchline {

/// Empty where the network is not installed. It fails where the network is damaged, less than 2 GB
/// of memory are free, or its worker fails.
[[nodiscard]] ThingFinder thing_finder();

}  // namespace touchline
