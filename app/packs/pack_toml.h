// Reads and writes pack.toml. The bytes may be anything: the result is a sound PackInfo or one
// finding with its line. Threads: pure functions.
#pragma once

#include "app/packs/pack.h"

#include <string>
#include <string_view>

namespace touchline {

inline constexpr const char* pack_table_name = "pack.toml";

/// Every field is in its range, names are plain, no picture and no language occurs twice, and every
/// sound belongs to a listed picture. O(n log n).
[[nodiscard]] PackResult<PackInfo> pack_info_of(std::string_view toml);

/// Reading it gives the same PackInfo. O(n).
[[nodiscard]] std::string toml_of(const PackInfo& info);

/// True for two or three letters, and parts of up to eight after hyphens: "de", "pt-BR".
[[nodiscard]] bool is_language_tag(std::string_view tag);

}  // namespace touchline
