// A PIN entered with six keys, and the cost of wrong ones. Threads: values and pure functions.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace touchline {

inline constexpr std::size_t shortest_pin = 4;
inline constexpr std::size_t longest_pin = 8;

/// Up and Down turn to the next digit; the first Up gives 1, the first Down gives 0. Select accepts
/// the digit.
struct PinEntry {
    std::string taken;         // the accepted digits
    std::optional<int> digit;  // 0 ... 9; none: not turned yet
};

[[nodiscard]] PinEntry turned(PinEntry entry, bool is_up);

/// Appends the digit, unless the entry is full or no digit was turned to.
[[nodiscard]] PinEntry with_digit_taken(PinEntry entry);

/// Digits only, 4 to 8.
[[nodiscard]] bool is_pin(const std::string& text);

/// From the fifth on, each wrong PIN costs time: 60 s, doubled by the next, at most an hour.
struct PinTries {
    int wrong = 0;
    double locked_until_s = 0.0;
};

/// After this many, the wait is longest; more are not counted.
inline constexpr int most_wrong_pins = 11;

/// `is_noted`: the try was written down before it was judged. A restart forgets one that was not,
/// so it costs at least the wait of the fifth.
[[nodiscard]] PinTries after_wrong_pin(PinTries tries, double now_s, bool is_noted = true);

/// The wait for the last wrong PIN begins anew after a restart, in full, so no clock has to be
/// trusted.
[[nodiscard]] PinTries tries_after_restart(int wrong, double now_s);

}  // namespace touchline
