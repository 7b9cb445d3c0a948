// A folder as a zip file that can be handed on. Threads: any.
#pragma once

#include "app/packs/pack.h"

#include <cstddef>
#include <string>
#include <vector>

namespace touchline {

/// The pack as a zip file, names in order, no dates: the same pack gives the same bytes, and
/// reading them gives the same files bit for bit. O(bytes).
[[nodiscard]] std::vector<std::byte> zip_of(const Pack& pack);

/// Every picture rewritten as a layered picture of the IMAGE project in one language
/// (image_layers.h), everything else as it was. By workers.
[[nodiscard]] PackResult<Pack> with_image_layers(Pack pack, const std::string& language);

/// read_pack() of a folder, written whole or not at all.
[[nodiscard]] PackResult<void> export_pack(const std::string& folder, const std::string& zip_file);

}  // namespace touchline
