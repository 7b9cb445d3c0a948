// A bundle of what this kiosk has for its house: settings, its own profiles, packs, and networks
// that do not ship. Threads: any; waits for the disk and for workers that pack.
#pragma once

#include "app/house/bundle.h"
#include "app/house/places.h"

#include <chrono>
#include <cstddef>
#include <vector>

namespace touchline {

/// Signed with the house's key. Its time is `now`, or later than that of any bundle that was made
/// or applied here, for clocks go wrong. Fails if something cannot be read or is too large.
[[nodiscard]] BundleResult<std::vector<std::byte>> make_bundle(const HousePlaces& places,
                                                               std::chrono::sys_seconds now);

}  // namespace touchline
