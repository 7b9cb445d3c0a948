#include "audio-cues/speech/resampler.h"

#include <cmath>
#include <numbers>

namespace touchline {
namespace {

double sinc(double x) {
    return x == 0.0 ? 1.0 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
}

/// Kaiser's window for -75 dB, at -1 ... 1.
double kaiser(double x) {
    const auto bessel = [](double z) { return std::cyl_bessel_i(0.0, z); };
    constexpr double beta = 7.3;
    return x * x >= 1.0 ? 0.0 : bessel(beta * std::sqrt(1.0 - x * x)) / bessel(beta);
}

}  // namespace

Resampler::Resampler() : taps_(static_cast<std::size_t>(up * 2 * half)) {
    // Tap i of filter p weighs the sample i before the newest, half samples being the delay.
    for (int p = 0; p < up; ++p) {
        double sum = 0.0;
        for (int i = 0; i < 2 * half; ++i) {
            const double x = i - (half - 1) - (1.0 - static_cast<double>(p) / up);
            sum += sinc(0.96 * x) * kaiser(x / half);
        }
        for (int i = 0; i < 2 * half; ++i) {
            const double x = i - (half - 1) - (1.0 - static_cast<double>(p) / up);
            taps_[static_cast<std::size_t>(p * 2 * half + i)] =
                static_cast<float>(sinc(0.96 * x) * kaiser(x / half) / sum);
        }
    }
}

void Resampler::push(float sample, std::vector<float>& out) {
    newest_ = (newest_ + 1) % history_.size();
    history_[newest_] = sample;
    for (; phase_ < up; phase_ += down) {
        const float* taps = &taps_[static_cast<std::size_t>(phase_ * 2 * half)];
        float sum = 0.0F;
        for (std::size_t i = 0; i < history_.size(); ++i) {
            sum += taps[i] * history_[(newest_ + history_.size() - i) % history_.size()];
        }
        out.push_back(sum);
    }
    phase_ -= up;
}

void Resampler::add(std::span<const std::int16_t> samples, std::vector<float>& out) {
    for (const std::int16_t sample : samples) push(static_cast<float>(sample) / 32767.0F, out);
}

void Resampler::finish(std::vector<float>& out) {
    for (int i = 0; i < half; ++i) push(0.0F, out);
    history_.fill(0.0F);
    phase_ = 0;
}

}  // namespace touchline
