// The speed of speech, in words a minute. Threads: constants and pure functions.
#pragma once

#include <array>
#include <cstddef>

namespace touchline {

/// The seven steps that a visitor chooses from: 50 to 200 % of the middle one.
inline constexpr std::array<double, 7> speech_rates_per_minute{65.0,  80.0,  100.0, 130.0,
                                                               165.0, 210.0, 260.0};

inline constexpr std::size_t default_speech_rate = 3;

/// The engine's settings. They never change the pitch.
struct EngineRate {
    int words_per_minute = 175;  // by its own count, 80 ... 450
    int word_gap = 0;            // pause between words, in the engine's units
};

/// Returns the setting for a step of speech_rates_per_minute (clamped) in a language of this pace
/// (Language::pace()). Measured: at the engine's slowest, English has 102 words a minute, so slower
/// speech uses pauses between words, which are also easier to follow than stretched vowels.
[[nodiscard]] EngineRate engine_rate(std::size_t step, double pace);

}  // namespace touchline
