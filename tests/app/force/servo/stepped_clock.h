// The wall clock of a program that loads stepped_clock.cpp first, in a file that the test maps as
// well. A time namespace has no wall clock of its own, and a test must not change the machine's.
#pragma once

#include <atomic>
#include <cstdint>

namespace touchline {

struct SteppedClock {
    std::atomic<std::int64_t> step_ns{0};
    std::atomic<std::uint64_t> reads{0};  // of the wall clock, by the program that loads it
};

/// The variable that names the file.
inline constexpr const char* stepped_clock_variable = "TOUCHLINE_STEPPED_CLOCK";

}  // namespace touchline
