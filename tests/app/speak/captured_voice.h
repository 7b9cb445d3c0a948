// How a voice ends that a text has taken over (captured_voice.cpp). Threads: constant data.
#pragma once

namespace touchline {

inline constexpr int act_worked = 100;
inline constexpr int act_refused = 101;
inline constexpr int act_unknown = 102;

}  // namespace touchline
