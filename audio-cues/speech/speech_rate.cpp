#include "audio-cues/speech/speech_rate.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace touchline {
namespace {

struct Measured {
    double setting;
    double per_minute;  // words of English, including pauses between sentences
};

constexpr std::array<Measured, 11> by_rate{{{80, 102.3},
                                            {100, 121.3},
                                            {120, 146.4},
                                            {140, 172.7},
                                            {160, 198.3},
                                            {180, 225.0},
                                            {200, 251.1},
                                            {220, 277.4},
                                            {240, 305.6},
                                            {260, 334.6},
                                            {280, 363.8}}};
// At the engine's slowest rate; slowest first.
constexpr std::array<Measured, 7> by_gap{
    {{20, 48.7}, {16, 53.9}, {12, 60.4}, {8, 68.6}, {4, 79.5}, {2, 86.2}, {0, 102.3}}};

/// Returns the setting for `per_minute`, linear between rows; beyond them the last one.
int setting_for(double per_minute, std::span<const Measured> rows) {
    const double wanted = std::clamp(per_minute, rows.front().per_minute, rows.back().per_minute);
    std::size_t i = 1;
    while (i + 1 < rows.size() && rows[i].per_minute < wanted) ++i;
    const Measured& low = rows[i - 1];
    const Measured& high = rows[i];
    const double t = (wanted - low.per_minute) / (high.per_minute - low.per_minute);
    return static_cast<int>(std::lround(low.setting + t * (high.setting - low.setting)));
}

}  // namespace

EngineRate engine_rate(std::size_t step, double pace) {
    const double wanted =
        speech_rates_per_minute[std::min(step, speech_rates_per_minute.size() - 1)];
    const double as_english = pace >= 0.5 && pace <= 2.0 ? wanted / pace : wanted;
    return {setting_for(as_english, by_rate), setting_for(as_english, by_gap)};
}

}  // namespace touchline
