// What finds the main things of a photograph for the kiosk: the network "figure" in its worker.
// Threads: the finder is called from any, one call at a time.
#pragma once

#include "app/loading/kiosk_stages.h"

namespace touchline {

/// Empty where the network is not installed. Where it is damaged, or its worker fails, nothing is
/// found, and the photograph stays as it was felt.
[[nodiscard]] ThingFinder thing_finder();

}  // namespace touchline
