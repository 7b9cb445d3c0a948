// Whether a pack can be used, and what would make it better: for teachers who make one.
// Threads: any; waits for workers, one a picture and one a sound.
#pragma once

#include "app/packs/pack.h"

#include <string>
#include <vector>

namespace touchline {

/// Refusals first, then gaps, then hints; each in the order of the files. Empty: nothing to say.
[[nodiscard]] std::vector<PackFinding> check_pack(const Pack& pack);

/// read_pack() and check_pack(); a pack that cannot be read is one finding.
[[nodiscard]] std::vector<PackFinding> check_pack(const std::string& path);

/// Is there no refusal among them?
[[nodiscard]] bool can_be_used(const std::vector<PackFinding>& findings);

}  // namespace touchline
