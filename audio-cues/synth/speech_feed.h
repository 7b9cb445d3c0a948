// Samples of speech on their way to the mixer: from one thread to one, without a lock.
#pragma once

#include "audio-cues/synth/ramp.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace touchline {

/// Mono at frame_rate_Hz. Writer: whoever makes speech; reader: the rendering thread.
class SpeechFeed {
  public:
    /// Holds `capacity_frames`, one second by default.
    explicit SpeechFeed(std::size_t capacity_frames = frame_rate_Hz);

    /// Writer: appends as much as there is room for; returns how much. Never waits.
    std::size_t write(std::span<const float> samples);

    /// Writer: what was written so far is not to be heard any more. It fades within ramp_s.
    void cut() { cut_.store(end_.load(std::memory_order_relaxed), std::memory_order_release); }

    /// Any thread: frames that wait, cut or not.
    [[nodiscard]] std::size_t waiting() const;

    /// Reader: the next frames, 0 after the last; while `is_paused` nothing is used up, after a
    /// fade. Returns whether speech sounds: any frame was read. O(frames).
    bool read(std::span<float> out, bool is_paused);

  private:
    float next(bool is_paused);

    std::vector<float> samples_;
    std::atomic<std::uint64_t> end_{0};
    std::atomic<std::uint64_t> begin_{0};
    std::atomic<std::uint64_t> cut_{0};  // up to here it is not wanted
    Ramp level_{1.0};                    // the reader's, as is all below
    std::uint64_t cut_seen_ = 0;
    std::uint64_t read_ = 0;
    std::uint64_t written_ = 0;
};

}  // namespace touchline
