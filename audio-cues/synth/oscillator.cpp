#include "audio-cues/synth/oscillator.h"

#include <array>
#include <cmath>
#include <numbers>

namespace touchline {
namespace {

constexpr std::size_t table_size = 2048;
using Table = std::array<float, table_size + 1>;  // repeats the first at the end

Table table_of(const std::array<double, 3>& harmonics, const std::array<int, 3>& numbers) {
    Table table;
    double peak = 0.0;
    std::array<double, table_size + 1> wave{};
    for (std::size_t i = 0; i <= table_size; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i % table_size) /
                             static_cast<double>(table_size);
        for (std::size_t k = 0; k < 3; ++k) wave[i] += harmonics[k] * std::sin(numbers[k] * angle);
        peak = std::max(peak, std::abs(wave[i]));
    }
    for (std::size_t i = 0; i <= table_size; ++i) table[i] = static_cast<float>(wave[i] / peak);
    return table;
}

// In the order of Timbre; made before the first frame, so that rendering only reads.
const std::array<Table, 3> tables{table_of({1.0, 0.0, 0.0}, {1, 1, 1}),
                                  table_of({1.0, 0.33, 0.15}, {1, 3, 5}),
                                  table_of({1.0, 0.4, 0.25}, {1, 2, 3})};

}  // namespace

float Oscillator::next(Timbre timbre, double frequency_Hz) {
    const Table& table = tables[static_cast<std::size_t>(timbre)];
    const double place = phase_ * static_cast<double>(table_size);
    const auto before = static_cast<std::size_t>(place);
    const auto part = static_cast<float>(place - static_cast<double>(before));
    const float sample = table[before] + part * (table[before + 1] - table[before]);
    const bool can_sound = frequency_Hz >= 0.0 && frequency_Hz <= 8000.0;  // false for NaN
    phase_ += can_sound ? frequency_Hz / frame_rate_Hz : 0.0;
    if (phase_ >= 1.0) phase_ -= 1.0;
    return can_sound ? sample : 0.0F;
}

}  // namespace touchline
