// A pack's picture as the kiosk reads it, and what its maker can do better; runs in the worker.
// Threads: pure functions.
#pragma once

#include "app/packs/unpack_answer.h"

#include <string>
#include <string_view>
#include <vector>

namespace touchline {

inline constexpr const char* map_entry = "map";
inline constexpr const char* sound_entry = "pcm";
inline constexpr const char* picture_entry = "svg";

/// Entry "map": map_bytes.h, in the first language. Findings do not name the file. A refusal comes
/// alone. O(text + points).
[[nodiscard]] UnpackAnswer check_picture(std::string_view svg,
                                         const std::vector<std::string>& languages);

/// Entry "svg": app/decode/image_layers.h.
[[nodiscard]] UnpackAnswer picture_in_layers(std::string_view svg, const std::string& language);

}  // namespace touchline
