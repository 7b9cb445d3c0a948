// Makes a WAV file as bytes. Threads: pure functions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace touchline {

/// 16-bit PCM with interleaved samples, and with an unknown chunk.
[[nodiscard]] std::string wav_bytes(std::uint32_t rate_Hz, std::uint32_t channels,
                                    const std::vector<int>& samples);

}  // namespace touchline
