// Converts between levels in dB and the gains that samples need. Threads: pure functions.
#pragma once

#include <cmath>

namespace touchline {

/// Returns the factor on samples; 0 dB is 1. NaN gives 0: silence.
[[nodiscard]] inline double gain_of_dB(double level_dB) {
    return std::isnan(level_dB) ? 0.0 : std::pow(10.0, level_dB / 20.0);
}

/// Returns -infinity for 0.
[[nodiscard]] inline double dB_of_gain(double gain) {
    return 20.0 * std::log10(gain);
}

}  // namespace touchline
