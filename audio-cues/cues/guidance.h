// Where a hand is and where something is, as sound and as one of nine places.
// Threads: pure functions.
#pragma once

#include "audio-cues/cues/cue.h"
#include "audio-cues/synth/continuous_voice.h"

#include <optional>

namespace touchline {

/// Nearer than near_m the pulses are as quick as they get; at far_m they are as slow, and beyond it
/// there are none, so that most of a picture's empty ground is quiet. On the line, within
/// on_line_m, there are none either: the hand feels it.
inline constexpr double on_line_m = 0.0005;
inline constexpr double near_m = 0.001;
inline constexpr double far_m = 0.015;
inline constexpr double quick_Hz = 12.0;
inline constexpr double slow_Hz = 1.5;

/// Pulses as a car gives them while it is parked: from slow_Hz at far_m to quick_Hz at near_m, each
/// halving of the distance a like step quicker. Silence on the line, beyond far_m and where there
/// is no line (infinite or NaN).
[[nodiscard]] ContinuousTone distance_tone(double distance_m);

/// The pitch of a place: 220 Hz at the lower rim of the area, two octaves more at the upper one.
[[nodiscard]] double pitch_Hz_of(Position place_W, const CueArea& area);

/// Left and right by pan, down and up by pitch.
[[nodiscard]] ContinuousTone position_tone(Position place_W, const CueArea& area);

/// Pulses from where the target lies: pan by its direction, quicker when it is near, higher when it
/// lies away from the visitor, lower when towards. Silence nearer than near_m: it is reached.
[[nodiscard]] ContinuousTone sonar_tone(Position hand_W, Position target_W);

/// Weaker twists of a shape in the hand make no sound; the strongest sounds from strong_Nm on.
inline constexpr double quiet_Nm = 1e-3;
inline constexpr double strong_Nm = 15e-3;

/// A hum, an octave and a half higher and three times as loud for the strongest, on the side to
/// which the shape is twisted: left where counter-clockwise. Silence for what is not finite.
[[nodiscard]] ContinuousTone torque_tone(double torque_Nm);

/// What a visitor chose to hear all the time.
struct ContinuousChoice {
    CueAmount amount = CueAmount::cues;
    bool has_position_tone = false;
    std::optional<Position> target_W;  // asked for: before all else, whatever the amount
    double torque_Nm = 0.0;            // of a shape in the hand
};

/// The one continuous sound: target, else the torque, else the position tone, else the distance.
[[nodiscard]] ContinuousTone continuous_tone(const ContinuousChoice& choice, Position hand_W,
                                             double distance_m, const CueArea& area);

/// The nine places of the area.
enum class Place : std::uint8_t {
    upper_left,
    top,
    upper_right,
    left,
    middle,
    right,
    lower_left,
    bottom,
    lower_right
};

/// By thirds of the area; what is outside counts to the nearest.
[[nodiscard]] Place place_of(Position place_W, const CueArea& area);

}  // namespace touchline
