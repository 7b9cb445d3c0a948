// Tells teachers who make a pack whether it can be used, and what would make it better.
// Threads: any; waits for workers, one per picture and per sound.
#pragma once

#include "app/packs/pack.h"

#include <string>
#include <vector>

namespace touchline {

/// Refusals first, then gaps, then hints, each in the order of the files. Empty: nothing to say.
[[nodiscard]] std::vector<PackFinding> check_pack(const Pack& pack);

/// read_pack() and check_pack(). A pack that cannot be read gives one finding.
[[nodiscard]] std::vector<PackFinding> check_pack(const std::string& path);

/// True if there is no refusal among them.
[[nodiscard]] bool can_be_used(const std::vector<PackFinding>& findings);

}  // namespace touchline
