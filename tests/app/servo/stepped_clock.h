// The wall clock of a program that has stepped_clock.cpp loaded before it, in a file that the test
// maps as well. A time namespace has no wall clock of its own, and the machine's is not a test's.
#pragma once

#include <atomic>
#include <cstdint>

namespace touchline {

struct SteppedClock {
    std::atomic<std::int64_t> step_ns{0};
    std::atomic<std::uint64_t> reads{0};  // of the wall clock, by whoever has it loaded
};

/// Names the file.
inline constexpr const char* stepped_clock_variable = "TOUCHLINE_STEPPED_CLOCK";

}  // namespace touchline
