// Sound of any rate at the mixer's. Threads: pure functions.
#pragma once

#include <span>
#include <vector>

namespace touchline {

inline constexpr int least_rate_Hz = 8000;
inline constexpr int most_rate_Hz = 192000;

/// The samples at frame_rate_Hz, by a windowed sinc: what lies below 9/10 of the lower half rate
/// passes within 0.1 dB. As long as before within a sample; nothing is delayed. `rate_Hz` from
/// least_rate_Hz to most_rate_Hz. O(samples).
[[nodiscard]] std::vector<float> at_frame_rate(std::span<const float> samples, int rate_Hz);

}  // namespace touchline
