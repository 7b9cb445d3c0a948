// What the handle can say to a visitor who neither sees nor hears: short shakes that differ.
// Threads: a plain value.
#pragma once

#include <cstddef>
#include <cstdint>

namespace touchline {

/// focus: another item. chosen: it was taken. error: that is not possible. edge: the end of a list
/// or of the drawing area. time_out: the session ends soon. How each one feels:
/// haptics/guidance/pattern.h.
enum class HandlePattern : std::uint8_t { none, focus, chosen, error, edge, time_out };

inline constexpr std::size_t handle_pattern_count = 6;

}  // namespace touchline
