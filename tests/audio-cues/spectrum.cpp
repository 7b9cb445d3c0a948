#include "tests/audio-cues/spectrum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>

namespace touchline {
namespace {

using Complex = std::complex<double>;

void transform(std::vector<Complex>& values) {
    const std::size_t size = values.size();
    for (std::size_t i = 1, j = 0; i < size; ++i) {
        std::size_t bit = size >> 1U;
        for (; (j & bit) != 0; bit >>= 1U) j ^= bit;
        j ^= bit;
        if (i < j) std::swap(values[i], values[j]);
    }
    for (std::size_t length = 2; length <= size; length *= 2) {
        const Complex turn = std::polar(1.0, -2.0 * std::numbers::pi / static_cast<double>(length));
        for (std::size_t start = 0; start < size; start += length) {
            Complex factor = 1.0;
            for (std::size_t k = start; k < start + length / 2; ++k) {
                const Complex odd = values[k + length / 2] * factor;
                values[k + length / 2] = values[k] - odd;
                values[k] += odd;
                factor *= turn;
            }
        }
    }
}

double blackman_harris(std::size_t i, std::size_t size) {
    const double x = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(size);
    return 0.35875 - 0.48829 * std::cos(x) + 0.14128 * std::cos(2.0 * x) -
           0.01168 * std::cos(3.0 * x);
}

std::vector<float> one_ear(std::span<const StereoFrame> frames, float StereoFrame::*ear) {
    std::vector<float> samples;
    samples.reserve(frames.size());
    for (const StereoFrame& frame : frames) samples.push_back(frame.*ear);
    return samples;
}

}  // namespace

std::vector<double> power_spectrum(std::span<const float> samples) {
    const std::size_t size = std::bit_floor(samples.size());
    std::vector<Complex> values(size);
    for (std::size_t i = 0; i < size; ++i) {
        values[i] = static_cast<double>(samples[i]) * blackman_harris(i, size);
    }
    transform(values);
    std::vector<double> powers;
    const double full = 0.35875 * static_cast<double>(size) / 2.0;
    for (std::size_t i = 0; i <= size / 2; ++i) powers.push_back(std::norm(values[i] / full));
    return powers;
}

double strongest_Hz(std::span<const float> samples) {
    const auto powers = power_spectrum(samples);
    const auto top = std::max_element(powers.begin() + 1, powers.end() - 1);
    if (*top == 0.0) return 0.0;
    // The top of the window is a parabola in dB.
    const double before = std::log(top[-1]);
    const double after = std::log(top[1]);
    const double part = 0.5 * (before - after) / (before - 2.0 * std::log(*top) + after);
    const double bin = static_cast<double>(top - powers.begin()) + part;
    return bin * frame_rate_Hz / static_cast<double>(std::bit_floor(samples.size()));
}

double rms(std::span<const float> samples) {
    double sum = 0.0;
    for (const float sample : samples) sum += double(sample) * double(sample);
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(samples.size(), 1)));
}

float peak(std::span<const float> samples) {
    float most = 0.0F;
    for (const float sample : samples) most = std::max(most, std::abs(sample));
    return most;
}

double loudest_above_dB(std::span<const float> samples, double above_Hz) {
    constexpr std::size_t size = 512;
    double most = 1e-20;
    for (std::size_t start = 0; start + size <= samples.size(); start += size / 8) {
        const auto powers = power_spectrum(samples.subspan(start, size));
        const auto first = static_cast<std::size_t>(above_Hz * size / frame_rate_Hz);
        most = std::max(most, *std::max_element(powers.begin() + static_cast<std::ptrdiff_t>(first),
                                                powers.end()));
    }
    return 10.0 * std::log10(most);
}

std::size_t first_sound(std::span<const float> samples) {
    const auto found =
        std::find_if(samples.begin(), samples.end(), [](float sample) { return sample != 0.0F; });
    return static_cast<std::size_t>(found - samples.begin());
}

std::vector<float> left_of_stereo(std::span<const StereoFrame> frames) {
    return one_ear(frames, &StereoFrame::left);
}

std::vector<float> right_of_stereo(std::span<const StereoFrame> frames) {
    return one_ear(frames, &StereoFrame::right);
}

std::vector<StereoFrame> rendered(Mixer& mixer, std::size_t frames) {
    std::vector<StereoFrame> out(frames);
    for (std::size_t start = 0; start < frames; start += static_cast<std::size_t>(block_frames)) {
        mixer.render(std::span(out).subspan(
            start, std::min(frames - start, static_cast<std::size_t>(block_frames))));
    }
    return out;
}

}  // namespace touchline
