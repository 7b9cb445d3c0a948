// Holds the handle of a device with three axes to the drawing plane by a spring of its own, which
// the force chain does not see, and takes the force in the plane away where the handle is off it: a
// line is felt on the plane alone. Threads: values and pure functions. O(1).
#pragma once

#include "config/types/vec2.h"
#include "haptics/pantograph/profile.h"

namespace touchline {

struct PlaneForce {
    Force in_plane_D;
    double across_N = 0.0;  // along the plane's normal, on the hand
};

/// Returns how much of the force in the plane acts at this distance from it, 0 ... 1: all on it,
/// none off it. 0 if the distance is not finite.
[[nodiscard]] double share_on_plane(const PlaneSpring& spring, double off_m);

/// Returns what the device is to make of the force that the chain told, for a handle `off_m` from
/// the plane along its normal, at `speed_m_per_s` away from there. `profile` is a Cartesian one;
/// `share` is DeviceCommand::plane_share. |across| <= share * the spring's most_N, and both
/// together are at most the profile's force limit: the plane's force gives way. It is also at most
/// share_on_plane() of the limit, for the chain may be late by its slew. At a share of 0, and from
/// let_go_m on, nothing acts across; above braked_m_per_s nothing drives across. A number that is
/// not finite, or a share outside 0 ... 1, gives no force at all.
[[nodiscard]] PlaneForce held_to_plane(const DeviceProfile& profile, Force told_D, double off_m,
                                       double speed_m_per_s, double share);

}  // namespace touchline
