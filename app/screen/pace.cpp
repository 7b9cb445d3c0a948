#include "app/screen/pace.h"

#include <algorithm>

namespace touchline {

namespace {

constexpr std::int64_t second_ns = 1'000'000'000;

}  // namespace

std::int64_t FrameLimiter::due_ns(std::int64_t place) const {
    // Split into seconds and rest, so that no product overflows however long the kiosk runs.
    return start_ns_ + place / rate_Hz_ * second_ns + place % rate_Hz_ * second_ns / rate_Hz_;
}

std::int64_t FrameLimiter::finish_frame(std::int64_t now_ns) {
    ++frames_;
    const std::int64_t elapsed_ns = std::max<std::int64_t>(now_ns - start_ns_, 0);
    std::int64_t next =
        elapsed_ns / second_ns * rate_Hz_ + elapsed_ns % second_ns * rate_Hz_ / second_ns;
    while (due_ns(next) <= now_ns) ++next;
    next = std::max(next, place_ + 1);
    skipped_ += next - place_ - 1;
    place_ = next;
    return due_ns(place_);
}

}  // namespace touchline
