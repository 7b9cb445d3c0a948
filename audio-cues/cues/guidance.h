// Tells by sound, and as one of nine places, where a hand is and where something is.
// Threads: pure functions.
#pragma once

#include "audio-cues/cues/cue_table.h"
#include "audio-cues/synth/voices.h"

#include <optional>

namespace touchline {

/// At near_m and nearer, the pulses are quickest; at far_m they are slowest, and beyond it there
/// are none, so that most of a picture's empty ground is quiet. There are none within on_line_m of
/// the line either, because the hand feels it.
inline constexpr double on_line_m = 0.0005;
inline constexpr double near_m = 0.001;
inline constexpr double far_m = 0.015;
inline constexpr double quick_Hz = 12.0;
inline constexpr double slow_Hz = 1.5;

/// Returns pulses like a car's parking sensor: from slow_Hz at far_m to quick_Hz at near_m, quicker
/// by the same step for each halving of the distance. Silent on the line, beyond far_m and if there
/// is no line (infinite or NaN).
[[nodiscard]] ContinuousTone distance_tone(double distance_m);

/// Returns the pitch of a place: 220 Hz at the lower edge of the area, two octaves more at the
/// upper one.
[[nodiscard]] double pitch_Hz_of(Position place_W, const CueArea& area);

/// Tells left and right by pan, down and up by pitch.
[[nodiscard]] ContinuousTone position_tone(Position place_W, const CueArea& area);

/// Returns pulses from where the target lies: pan by its direction, quicker if it is near, higher
/// if it lies away from the visitor, lower if towards. Silent nearer than near_m, when it is
/// reached.
[[nodiscard]] ContinuousTone sonar_tone(Position hand_W, Position target_W);

/// Weaker twists of a shape in the hand make no sound; the sound is strongest from strong_Nm on.
inline constexpr double quiet_Nm = 1e-3;
inline constexpr double strong_Nm = 15e-3;

/// Returns a hum, an octave and a half higher and three times as loud for the strongest twist, on
/// the side to which the shape is twisted: left if counter-clockwise. Silent if not finite.
[[nodiscard]] ContinuousTone torque_tone(double torque_Nm);

/// What a visitor chose to hear continuously.
struct ContinuousChoice {
    CueAmount amount = CueAmount::cues;
    bool has_position_tone = false;
    std::optional<Position> target_W;  // asked for; comes first, whatever the amount
    double torque_Nm = 0.0;            // of a shape in the hand
};

/// Returns the one continuous sound: the target, else the torque, else the position tone, else the
/// distance.
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

/// Returns the place by thirds of the area; a place outside counts to the nearest one.
[[nodiscard]] Place place_of(Position place_W, const CueArea& area);

}  // namespace touchline
