#include "audio-cues/output/frame_clock.h"

#include <cstdlib>

namespace touchline {
namespace {

constexpr std::int64_t second_ns = 1'000'000'000;
constexpr std::int64_t jump_ns = 50'000'000;  // more is not jitter: the device stood still

/// Does not overflow for thousands of years.
std::int64_t ns_of(FrameTime frame) {
    return frame / frame_rate_Hz * second_ns + frame % frame_rate_Hz * second_ns / frame_rate_Hz;
}

}  // namespace

void FrameClock::told(FrameTime frame, std::int64_t now_ns) {
    const std::int64_t start_ns = now_ns - ns_of(frame);
    const std::int64_t last_ns = start_ns_.load(std::memory_order_relaxed);
    const bool is_new = last_ns == nothing || std::abs(start_ns - last_ns) > jump_ns;
    start_ns_.store(is_new ? start_ns : last_ns + (start_ns - last_ns) / 32,
                    std::memory_order_relaxed);
}

FrameTime FrameClock::frame_at(std::int64_t time_ns) const {
    const std::int64_t start_ns = start_ns_.load(std::memory_order_relaxed);
    if (start_ns == nothing) return 0;
    const std::int64_t since_ns = time_ns - start_ns;
    const FrameTime frame =
        since_ns / second_ns * frame_rate_Hz + since_ns % second_ns * frame_rate_Hz / second_ns;
    return frame + lead_frames;
}

}  // namespace touchline
