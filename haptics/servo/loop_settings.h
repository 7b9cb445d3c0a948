// The stiffness and damping that a loop of a given rate and delay may render with a given device
// (facts 7.5).
// Threads: a pure function.
#pragma once

#include "haptics/pantograph/profile.h"

namespace touchline {

struct LoopSettings {
    double stiffness_N_per_m = 0.0;          // at the start
    double largest_stiffness_N_per_m = 0.0;  // stable for every hand, and for none
    double damping_Ns_per_m = 0.0;           // virtual, see virtual_damping.h
};

/// `period_s` > 0 between ticks and `delay_s` >= 0 from reading the angles to the torque's effect,
/// both as measured; a delay below one period counts as one period, since the transport time cannot
/// be seen.
///   K     = min(0.95 (b + 1 N s/m) / (T/2 + t_d), 2 f_c / Delta, 1500): a light hand's limit, the
///           encoder's, and the point beyond which stiffer walls feel alike
///   K_max = min(0.9 (b + B) / (T/2 + t_d), 2 f_c / Delta, 1500), at least K
///   B     = 1.5 N s/m, 2 from 2 kHz on
/// From 2000 N/m up, the shipped loop rings at 4 kHz when a light tip is hit, whatever the period
/// allows: the velocity's window is as long as it takes to count encoder steps, not as short as the
/// ticks (tests/stability/README.md).
[[nodiscard]] LoopSettings loop_settings(const DeviceProfile& profile, double period_s,
                                         double delay_s);

}  // namespace touchline
