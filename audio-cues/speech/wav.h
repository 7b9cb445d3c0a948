// Recorded sound in a file. Threads: pure functions except for reading the file.
#pragma once

#include "config/types/result.h"

#include <span>
#include <string>
#include <vector>

namespace touchline {

/// Decodes a WAV of 16-bit PCM, mono or stereo (mixed down), at 48 000 or 22 050 Hz and at most 60
/// s, to mono at frame_rate_Hz, full scale 1. Anything else gives a one-line error.
[[nodiscard]] Result<std::vector<float>> decode_wav(std::span<const char> bytes);

[[nodiscard]] Result<std::vector<float>> read_wav(const std::string& path);

}  // namespace touchline
