// What lay at a place of a bundle when a person was told what it changes, and whether it still
// does. Threads: any, each call by itself; calls wait for the disk.
#pragma once

#include "app/documents/packs/pack.h"
#include "app/house/places.h"

#include <string>

namespace touchline {

/// What lies there, by a sum over all of it.
struct SeenThing {
    HouseRoot root = HouseRoot::profiles;
    std::string name;  // in the root's folder
    std::string sum;   // empty: there was nothing that can be used
};

/// What lies there now: a profile's file or a pack's folder. O(bytes).
[[nodiscard]] SeenThing see(const HousePlaces& places, HouseRoot root, const std::string& name);

/// The same of a pack that was read just now.
[[nodiscard]] SeenThing seen_pack(const std::string& name, const PackResult<Pack>& pack);

/// True if what lies there now is what was seen. O(bytes).
[[nodiscard]] bool is_as_seen(const HousePlaces& places, const SeenThing& thing);

}  // namespace touchline
