// A PIN entered with six keys, the cost of wrong ones, and both on the disk.
// Threads: values and pure functions; the files any, each call by itself: they wait for the disk,
// and a hash takes some hundredths of a second.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <filesystem>
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

/// Digits only, `shortest_pin` to `longest_pin` of them.
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

// On the disk: a yescrypt hash, and how many wrong ones there were, so that a restart gives no free
// try. Each is a small file that only the kiosk's user may read.

/// operator.pin beside the site's settings.
[[nodiscard]] std::filesystem::path pin_file();

/// True if a PIN is kept. A file that exists and cannot be read counts: nobody gets in by breaking
/// it.
[[nodiscard]] bool has_pin(const std::filesystem::path& file);

/// Stores a PIN of digits as above. The file has mode 0600 and appears whole or not at all.
[[nodiscard]] Result<void> keep_pin(const std::filesystem::path& file, const std::string& pin);

/// Takes as long for a wrong PIN as for the right one. Fails if the file is missing, is no hash, or
/// can be read or written by others.
[[nodiscard]] Result<bool> is_right_pin(const std::filesystem::path& file, const std::string& pin);

/// operator.tries beside the PIN.
[[nodiscard]] std::filesystem::path pin_tries_file(const std::filesystem::path& pin);

/// Called before a PIN is judged, with that one counted. It is on the disk when the call returns,
/// so pulling the plug undoes nothing.
[[nodiscard]] Result<void> keep_pin_tries(const std::filesystem::path& file, int wrong);

/// Returns 0 if there is no file: nothing was tried. Fails if the file is damaged or open to
/// others; count that as most_wrong_pins.
[[nodiscard]] Result<int> read_pin_tries(const std::filesystem::path& file);

}  // namespace touchline
