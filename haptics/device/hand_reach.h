// Whether a hand can have moved the handle from one pose of the joints to another in a given time.
// What it cannot is an encoder that leapt. Threads: a pure function. No allocation. O(1).
#pragma once

#include "config/types/vec2.h"
#include "haptics/pantograph/profile.h"

namespace touchline {

/// How much later than it was asked a device may have looked.
inline constexpr double sampling_s = 0.001;

/// `profile`: with the unit's own counts. age_s >= 0: how old the first pose is; the
/// second may be sampling_s newer. False if anything is not finite.
[[nodiscard]] bool can_a_hand_move(const DeviceProfile& profile, JointAngles from, JointAngles to,
                                   double age_s);

}  // namespace touchline
