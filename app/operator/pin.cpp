#include "app/operator/pin.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr int free_tries = 5;
constexpr double first_lock_s = 60.0;
constexpr double longest_lock_s = 3600.0;
constexpr int digits = 10;

}  // namespace

PinEntry turned(PinEntry entry, bool is_up) {
    if (entry.digit)
        entry.digit = (*entry.digit + (is_up ? 1 : digits - 1)) % digits;
    else
        entry.digit = is_up ? 1 : 0;
    return entry;
}

PinEntry with_digit_taken(PinEntry entry) {
    if (entry.digit && entry.taken.size() < longest_pin)
        entry.taken += static_cast<char>('0' + *entry.digit);
    entry.digit.reset();
    return entry;
}

bool is_pin(const std::string& text) {
    return text.size() >= shortest_pin && text.size() <= longest_pin &&
           std::all_of(text.begin(), text.end(),
                       [](char letter) { return letter >= '0' && letter <= '9'; });
}

PinTries after_wrong_pin(PinTries tries, double now_s, bool is_noted) {
    const int wrong = std::min(tries.wrong + 1, most_wrong_pins);
    return tries_after_restart(is_noted ? wrong : std::max(wrong, free_tries), now_s);
}

PinTries tries_after_restart(int wrong, double now_s) {
    if (wrong < free_tries) return {wrong, 0.0};
    const double lock_s = first_lock_s * std::exp2(wrong - free_tries);
    return {wrong, now_s + std::min(lock_s, longest_lock_s)};
}

}  // namespace touchline
