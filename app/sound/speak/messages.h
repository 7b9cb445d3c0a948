// What the kiosk and its voice exchange: packets on one socket, each whole or not at all.
// Threads: plain values.
#pragma once

#include "audio-cues/speech/speech_input.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace touchline {

/// Sent to the voice once: what to say.
struct SpeakOrder {
    EngineRate rate;
    std::uint32_t bytes = 0;  // length of the text, at most its size
    std::array<char, longest_speech_bytes> text{};
};

/// From the voice: the next piece. The last may be empty.
struct SpokenPiece {
    static constexpr std::size_t most_samples = 1024;

    std::uint32_t is_last = 0;
    std::uint32_t count = 0;                    // at most most_samples
    std::array<float, most_samples> samples{};  // at frame_rate_Hz, full scale 1
};

static_assert(std::is_trivially_copyable_v<SpeakOrder> &&
              std::is_trivially_copyable_v<SpokenPiece>);

}  // namespace touchline
