// A PIN entered with six keys, and what wrong ones cost. Threads: values and pure functions.
#pragma once

#include <cstddef>
#include <string>

namespace touchline {

inline constexpr std::size_t shortest_pin = 4;
inline constexpr std::size_t longest_pin = 8;

/// Up and Down change the next digit, from 0 each time; Next accepts it.
struct PinEntry {
    std::string taken;  // digits
    int digit = 0;      // 0 ... 9
};

[[nodiscard]] PinEntry turned(PinEntry entry, bool is_up);

/// With the digit at its end; as it was where no more go in.
[[nodiscard]] PinEntry with_digit_taken(PinEntry entry);

/// Digits only, 4 to 8.
[[nodiscard]] bool is_pin(const std::string& text);

/// From the fifth wrong PIN on each costs time: 60 s, doubled by the next, at most an hour.
struct PinTries {
    int wrong = 0;
    double locked_until_s = 0.0;
};

/// So many make the wait the longest; more are not counted.
inline constexpr int most_wrong_pins = 11;

/// `is_noted`: it was written down before it was judged. One that was not is forgotten by a restart
/// and costs the wait of the fifth at least.
[[nodiscard]] PinTries after_wrong_pin(PinTries tries, double now_s, bool is_noted = true);

/// What the last wrong one cost counts anew after a restart, in full: no clock has to be believed.
[[nodiscard]] PinTries tries_after_restart(int wrong, double now_s);

}  // namespace touchline
