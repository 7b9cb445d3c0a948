// Noise that depends only on a seed and a counter: the same in any order, on any machine.
// Threads: a pure function.
#pragma once

#include <cstdint>

namespace touchline::stability {

/// Returns a number evenly distributed in [0, 1), by SplitMix64.
[[nodiscard]] constexpr double even_noise(std::uint64_t seed, std::uint64_t counter) {
    std::uint64_t z = seed * 0xd1342543de82ef95U + (counter + 1) * 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
}

}  // namespace touchline::stability
