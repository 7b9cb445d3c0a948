// Writes a folder as a zip file for other people. Threads: any.
#pragma once

#include "app/packs/pack.h"

#include <cstddef>
#include <string>
#include <vector>

namespace touchline {

/// The pack as a zip file, with names in order and no dates. The same pack gives the same bytes,
/// and reading them gives the same files, bit for bit. O(bytes).
[[nodiscard]] std::vector<std::byte> zip_of(const Pack& pack);

/// Rewrites every picture as a layered picture of the IMAGE project in one language
/// (image_layers.h), and leaves everything else as it was. Waits for workers.
[[nodiscard]] PackResult<Pack> with_image_layers(Pack pack, const std::string& language);

/// read_pack() of a folder; the zip file is written whole or not at all.
[[nodiscard]] PackResult<void> export_pack(const std::string& folder, const std::string& zip_file);

}  // namespace touchline
