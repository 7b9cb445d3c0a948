// Passes samples of speech to the mixer, from one thread to one, without a lock.
#pragma once

#include "audio-cues/synth/gain.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace touchline {

/// Mono at frame_rate_Hz. Writer: the thread that makes speech; reader: the rendering thread.
class SpeechFeed {
  public:
    /// Holds `capacity_frames`, one second by default.
    explicit SpeechFeed(std::size_t capacity_frames = frame_rate_Hz);

    /// Writer: appends as many samples as there is room for and returns how many. Never waits.
    std::size_t write(std::span<const float> samples);

    /// Writer: drops everything written so far. It fades within ramp_s.
    void cut() { cut_.store(end_.load(std::memory_order_relaxed), std::memory_order_release); }

    /// Any thread: the number of waiting frames, cut or not.
    [[nodiscard]] std::size_t waiting() const;

    /// Reader: gives the next frames, 0 after the last. While `is_paused`, nothing is used up,
    /// after a fade. Returns whether speech sounds, which means any frame was read. O(frames).
    bool read(std::span<float> out, bool is_paused);

  private:
    float next(bool is_paused);

    std::vector<float> samples_;
    std::atomic<std::uint64_t> end_{0};
    std::atomic<std::uint64_t> begin_{0};
    std::atomic<std::uint64_t> cut_{0};  // frames up to here are dropped
    Ramp level_{1.0};                    // the reader's, like everything below
    std::uint64_t cut_seen_ = 0;
    std::uint64_t read_ = 0;
    std::uint64_t written_ = 0;
};

}  // namespace touchline
