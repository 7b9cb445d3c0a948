// Which frame sounds at which time. Threads: told() by the rendering thread, the rest by any.
#pragma once

#include "audio-cues/synth/frames.h"
#include "audio-cues/synth/limiter.h"

#include <atomic>
#include <cstdint>

namespace touchline {

/// Two clocks drift and a device asks in bursts: what is told is smoothed, so that sounds keep the
/// times between them.
class FrameClock {
  public:
    /// The mixer is about to render `frame`, at `now_ns` of the monotonic clock.
    void told(FrameTime frame, std::int64_t now_ns);

    /// The frame to stamp what happened at `time_ns` with, so that it is heard a block later than
    /// the mixer was there and is not over yet: the limiter delays it by the rest of that block. 0,
    /// which means now, before anything was told.
    [[nodiscard]] FrameTime frame_at(std::int64_t time_ns) const;

    static constexpr int lead_frames = block_frames - Limiter::look_ahead_frames;

  private:
    static constexpr std::int64_t nothing = INT64_MIN;
    std::atomic<std::int64_t> start_ns_{nothing};  // when frame 0 would have been
};

}  // namespace touchline
