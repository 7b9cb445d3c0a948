// What differs from unit to unit of one device profile, as homing found it and a file keeps it.
// Threads: a value.
#pragma once

#include "config/types/vec2.h"

#include <optional>

namespace touchline {

/// angle = home + offset + scale * (what the board says - what it says at home), joint by joint.
struct Calibration {
    JointAngles offset;                     // rad, finite
    JointAngles scale{1.0, 1.0};            // 0.8 to 1.25: true turn over what the encoder says
    bool are_motors_swapped = false;        // each joint is on the other port
    bool has_all_counts = false;            // the board counts all it is told, not the half
    std::optional<double> torque_limit_Nm;  // of one motor, > 0; nothing: the profile's
};

}  // namespace touchline
