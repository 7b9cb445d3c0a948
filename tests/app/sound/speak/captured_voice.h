// The exit statuses of a voice that a text has captured (captured_voice.cpp).
// Threads: constant data.
#pragma once

namespace touchline {

inline constexpr int act_worked = 100;
inline constexpr int act_refused = 101;
inline constexpr int act_unknown = 102;

}  // namespace touchline
