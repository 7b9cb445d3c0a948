// Recorded sound in a file. Threads: pure functions but for the file.
#pragma once

#include "config/types/result.h"

#include <span>
#include <string>
#include <vector>

namespace touchline {

/// Mono at frame_rate_Hz, full scale 1, of a WAV of 16-bit PCM, mono or stereo (mixed down), at
/// 48 000 or 22 050 Hz and at most 60 s. Anything else: one line.
[[nodiscard]] Result<std::vector<float>> decode_wav(std::span<const char> bytes);

[[nodiscard]] Result<std::vector<float>> read_wav(const std::string& path);

}  // namespace touchline
