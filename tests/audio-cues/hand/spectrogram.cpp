#include "tests/audio-cues/hand/spectrogram.h"

#include "tests/audio-cues/spectrum.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr int rows = 72;   // per ear
constexpr int row_px = 2;  // height
constexpr std::size_t window = 2048;
constexpr double darkest_dB = -70.0;

/// The power of one row, from the powers of a window.
double power_of_row(const std::vector<double>& powers, int row) {
    const auto bin_of = [](double r) {
        const double frequency_Hz = 110.0 * std::exp2(r / 12.0);
        return static_cast<std::size_t>(frequency_Hz * static_cast<double>(window) / frame_rate_Hz);
    };
    const std::size_t first = bin_of(row);
    const std::size_t last = std::max(first + 1, bin_of(row + 1));
    return *std::max_element(powers.begin() + static_cast<std::ptrdiff_t>(first),
                             powers.begin() + static_cast<std::ptrdiff_t>(last));
}

}  // namespace

Spectrogram spectrogram_of(std::span<const StereoFrame> sound, int width) {
    Spectrogram picture{width, 2 * rows * row_px + row_px, {}};
    picture.pixels.assign(static_cast<std::size_t>(picture.width * picture.height), 64);
    const std::size_t step =
        std::max<std::size_t>(480, sound.size() / static_cast<std::size_t>(width));
    const std::vector<float> ears[] = {left_of_stereo(sound), right_of_stereo(sound)};
    for (int ear = 0; ear < 2; ++ear) {
        for (int x = 0; x < width; ++x) {
            const std::size_t start = static_cast<std::size_t>(x) * step;
            std::vector<double> powers(window / 2 + 1, 0.0);
            if (start + window <= ears[ear].size()) {
                powers = power_spectrum(std::span(ears[ear]).subspan(start, window));
            }
            for (int y = 0; y < rows * row_px; ++y) {
                const double power = power_of_row(powers, rows - 1 - y / row_px);
                const double level_dB = 10.0 * std::log10(power + 1e-12);
                const double share = std::clamp(1.0 - level_dB / darkest_dB, 0.0, 1.0);
                const int line = ear * (rows + 1) * row_px + y;
                picture.pixels[static_cast<std::size_t>(line * width + x)] =
                    static_cast<std::uint8_t>(std::lround(255.0 * share));
            }
        }
    }
    return picture;
}

}  // namespace touchline
