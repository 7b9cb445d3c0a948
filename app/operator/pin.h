// A PIN entered with six keys, and what wrong ones cost. Threads: values and pure functions.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace touchline {

inline constexpr std::size_t shortest_pin = 4;
inline constexpr std::size_t longest_pin = 8;

/// Up and Down turn to the next digit, the first Up to 1 and the first Down to 0; Select accepts
/// it.
struct PinEntry {
    std::string taken;         // digits
    std::optional<int> digit;  // 0 ... 9; none: not turned yet
};

[[nodiscard]] PinEntry turned(PinEntry entry, bool is_up);

/// The digit goes to the end, unless the entry is full or no digit was turned to.
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
