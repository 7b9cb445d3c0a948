// Tells which frame sounds at which time. Threads: told() by the rendering thread, the rest by any.
#pragma once

#include "audio-cues/synth/frames.h"
#include "audio-cues/synth/limiter.h"

#include <atomic>
#include <cstdint>

namespace touchline {

/// Smooths the times it is told, because two clocks drift and a device asks in bursts; so sounds
/// keep the times between them.
class FrameClock {
  public:
    /// Tells the clock that the mixer is about to render `frame`, at `now_ns` of the monotonic
    /// clock.
    void told(FrameTime frame, std::int64_t now_ns);

    /// Returns the frame to stamp an event at `time_ns` with. It has not been rendered yet, and is
    /// heard one block after the mixer was at that time: the limiter adds the rest of that block.
    /// Returns 0, which means now, before told() was called.
    [[nodiscard]] FrameTime frame_at(std::int64_t time_ns) const;

    static constexpr int lead_frames = block_frames - Limiter::look_ahead_frames;

  private:
    static constexpr std::int64_t nothing = INT64_MIN;
    std::atomic<std::int64_t> start_ns_{nothing};  // when frame 0 would have been
};

}  // namespace touchline
