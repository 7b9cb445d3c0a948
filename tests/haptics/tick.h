// The length of a tick in the tests that step a part of the loop themselves.
#pragma once

namespace touchline {

inline constexpr double tick_s = 1e-3;

}  // namespace touchline
