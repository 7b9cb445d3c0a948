// Reads recordings; runs in the worker. Threads: one.
#pragma once

#include "app/packs/pack_finding.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace touchline {

struct ReadSound {
    std::vector<std::int16_t> samples;  // mono at 48 000 Hz, full scale 32767
    std::vector<PackFinding> findings;
};

/// Reads WAV, OGG or FLAC of one or two channels (mixed down) at 8 to 192 kHz, at most
/// pack_limits.sound_s long. The findings do not name the file. O(samples).
[[nodiscard]] PackResult<ReadSound> read_sound(std::span<const std::byte> bytes);

}  // namespace touchline
