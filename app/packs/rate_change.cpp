#include "app/packs/rate_change.h"

#include "audio-cues/synth/frames.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

namespace touchline {
namespace {

constexpr int zeros = 24;  // of the sinc, to each side

/// A low pass of unit gain as a function of time in samples of the lower rate; 0 beyond `zeros`.
double pulse(double t) {
    if (std::abs(t) >= zeros) return 0.0;
    constexpr double cutoff = 0.95;
    const double x = std::numbers::pi * cutoff * t;
    const double sinc = x == 0.0 ? 1.0 : std::sin(x) / x;
    const double u = std::numbers::pi * t / zeros;
    const double blackman = 0.42 + 0.5 * std::cos(u) + 0.08 * std::cos(2.0 * u);
    return cutoff * sinc * blackman;
}

/// One filter for each place that an output can have between two inputs.
struct Filters {
    std::int64_t up = 1;  // outputs for `down` inputs
    std::int64_t down = 1;
    std::int64_t half = 0;  // taps to each side
    std::vector<float> taps;

    [[nodiscard]] std::size_t width() const { return static_cast<std::size_t>(2 * half); }
};

Filters filters_for(int rate_Hz) {
    Filters made;
    const int common = std::gcd(frame_rate_Hz, rate_Hz);
    made.up = frame_rate_Hz / common;
    made.down = rate_Hz / common;
    const double stretch =
        std::max(1.0, static_cast<double>(rate_Hz) / static_cast<double>(frame_rate_Hz));
    made.half = static_cast<std::int64_t>(std::ceil(zeros * stretch));
    made.taps.reserve(static_cast<std::size_t>(made.up) * made.width());
    for (std::int64_t phase = 0; phase < made.up; ++phase) {
        const double at = static_cast<double>(phase) / static_cast<double>(made.up);
        for (std::int64_t tap = 0; tap < 2 * made.half; ++tap) {
            const double t = static_cast<double>(tap - made.half + 1) - at;
            made.taps.push_back(static_cast<float>(pulse(t / stretch) / stretch));
        }
    }
    return made;
}

}  // namespace

std::vector<float> at_frame_rate(std::span<const float> samples, int rate_Hz) {
    if (rate_Hz == frame_rate_Hz) return {samples.begin(), samples.end()};
    const Filters filters = filters_for(rate_Hz);
    const auto count = static_cast<std::int64_t>(samples.size());
    const std::int64_t outputs = count * filters.up / filters.down;
    std::vector<float> made(static_cast<std::size_t>(outputs));
    for (std::int64_t n = 0; n < outputs; ++n) {
        const std::int64_t before = n * filters.down / filters.up;
        const auto phase = static_cast<std::size_t>(n * filters.down % filters.up);
        const float* const taps = &filters.taps[phase * filters.width()];
        float sum = 0.0F;
        const std::int64_t first = before - filters.half + 1;
        const std::int64_t from = std::max<std::int64_t>(0, -first);
        const std::int64_t to = std::min(2 * filters.half, count - first);
        for (std::int64_t tap = from; tap < to; ++tap)
            sum += taps[tap] * samples[static_cast<std::size_t>(first + tap)];
        made[static_cast<std::size_t>(n)] = sum;
    }
    return made;
}

}  // namespace touchline
