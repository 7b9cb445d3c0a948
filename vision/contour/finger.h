// What a finger can tell apart, in millimetres at the handle: guidance for raised-line pictures.
// Threads: constants.
#pragma once

namespace touchline {

/// The shortest line worth a finger's time.
inline constexpr double kShortestLine_mm = 4.0;

/// Two lines closer than this feel like one.
inline constexpr double kLeastApart_mm = 3.2;

}  // namespace touchline
