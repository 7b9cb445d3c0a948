// The shape that a hand holds to probe a picture. Threads: a plain value.
#pragma once

#include <cstddef>
#include <cstdint>

namespace touchline {

/// none: a point, as for nearly everybody.
enum class HeldShape : std::uint8_t { none, disc, bar, ell, key };

inline constexpr std::size_t held_shape_count = 5;

}  // namespace touchline
