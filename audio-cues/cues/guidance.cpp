#include "audio-cues/cues/guidance.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double continuous_level = 0.3;
constexpr double lowest_Hz = 220.0;
constexpr double octaves = 2.0;
constexpr double hum_Hz = 110.0;
constexpr double hum_octaves = 1.5;
constexpr double hum_pan = 0.8;

/// Returns 0 at far_m ... 1 at near_m, by halvings.
double nearness(double distance_m) {
    const double between = std::log(far_m / distance_m) / std::log(far_m / near_m);
    return std::clamp(between, 0.0, 1.0);
}

double pulse_Hz_of(double distance_m) {
    return slow_Hz * std::pow(quick_Hz / slow_Hz, nearness(distance_m));
}

int third_of(double value, double half) {
    return value < -half / 3.0 ? 0 : value > half / 3.0 ? 2 : 1;
}

}  // namespace

ContinuousTone distance_tone(double distance_m) {
    if (!(distance_m > on_line_m && distance_m <= far_m)) return {};
    return {.frequency_Hz = 440.0,
            .level = continuous_level,
            .pulse_Hz = pulse_Hz_of(distance_m),
            .timbre = Timbre::hollow};
}

double pitch_Hz_of(Position place_W, const CueArea& area) {
    const double height = 0.5 + 0.5 * place_W.y / area.half_height_m;
    const double share = std::isfinite(height) ? std::clamp(height, 0.0, 1.0) : 0.5;
    return lowest_Hz * std::exp2(octaves * share);
}

ContinuousTone position_tone(Position place_W, const CueArea& area) {
    return {.frequency_Hz = pitch_Hz_of(place_W, area),
            .level = continuous_level,
            .pan = pan_of(place_W, area)};
}

ContinuousTone sonar_tone(Position hand_W, Position target_W) {
    const Position way = target_W - hand_W;
    const double distance_m = norm(way);
    if (!std::isfinite(distance_m) || distance_m <= near_m) return {};
    return {.frequency_Hz = 660.0 * std::exp2(way.y / distance_m),
            .level = continuous_level,
            .pan = way.x / distance_m,
            .pulse_Hz = pulse_Hz_of(distance_m),
            .timbre = Timbre::bright};
}

ContinuousTone torque_tone(double torque_Nm) {
    const double size_Nm = std::abs(torque_Nm);
    if (!std::isfinite(size_Nm) || size_Nm <= quiet_Nm) return {};
    const double share = std::min(1.0, (size_Nm - quiet_Nm) / (strong_Nm - quiet_Nm));
    return {.frequency_Hz = hum_Hz * std::exp2(hum_octaves * share),
            .level = continuous_level * (1.0 + 2.0 * share) / 3.0,
            .pan = torque_Nm > 0.0 ? -hum_pan : hum_pan,
            .timbre = Timbre::bright};
}

ContinuousTone continuous_tone(const ContinuousChoice& choice, Position hand_W, double distance_m,
                               const CueArea& area) {
    if (choice.target_W) return sonar_tone(hand_W, *choice.target_W);
    const bool is_twisted = std::abs(choice.torque_Nm) > quiet_Nm;
    if (is_twisted && choice.amount != CueAmount::none) return torque_tone(choice.torque_Nm);
    if (choice.amount != CueAmount::full) return {};
    return choice.has_position_tone ? position_tone(hand_W, area) : distance_tone(distance_m);
}

Place place_of(Position place_W, const CueArea& area) {
    const int column = third_of(place_W.x, area.half_width_m);
    const int row = 2 - third_of(place_W.y, area.half_height_m);  // from the top
    return static_cast<Place>(3 * row + column);
}

}  // namespace touchline
