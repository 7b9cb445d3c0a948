// Sound of any rate at the mixer's.
#pragma once

#include <memory>
#include <span>
#include <vector>

struct SRC_STATE_tag;

namespace touchline {

inline constexpr int least_rate_Hz = 8000;
inline constexpr int most_rate_Hz = 192000;

/// Converts `rate_Hz`, least_rate_Hz to most_rate_Hz, to frame_rate_Hz by libsamplerate's windowed
/// sinc: what lies below 17/20 of the lower half rate passes within 0.1 dB (from a higher rate,
/// where a shorter sinc saves time, below 2/3), images are below -70 dB. Nothing is delayed.
/// Threads: one thread's.
class Resampler {
  public:
    /// Throws std::bad_alloc.
    explicit Resampler(int rate_Hz);

    /// O(samples).
    void add(std::span<const float> samples, std::vector<float>& out);

    /// The end of the sound; nothing may be added after it.
    void finish(std::vector<float>& out);

  private:
    struct Close {
        void operator()(SRC_STATE_tag* state) const;
    };

    void process(std::span<const float> samples, bool is_end, std::vector<float>& out);

    std::unique_ptr<SRC_STATE_tag, Close> state_;
    double ratio_;
};

/// All of a sound at once, within a sample as long as before. Threads: a pure function.
[[nodiscard]] std::vector<float> at_frame_rate(std::span<const float> samples, int rate_Hz);

}  // namespace touchline
