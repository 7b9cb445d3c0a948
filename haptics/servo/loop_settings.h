// What a loop of a given rate and delay may render with a given device (facts 7.5): stiffness and
// damping, and the damping of a sampled spring (facts 1.3, 1.4).
// Threads: plain values and pure functions.
#pragma once

#include "config/types/hand_state.h"
#include "config/types/vec2.h"
#include "haptics/pantograph/profile.h"
#include "haptics/servo/real_time.h"

#include <algorithm>

namespace touchline {

struct LoopSettings {
    double stiffness_N_per_m = 0.0;          // at the start
    double largest_stiffness_N_per_m = 0.0;  // stable for every hand, and for none
    double damping_Ns_per_m = 0.0;           // virtual, see damped()
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
/// ticks (tests/lab/stability/README.md).
[[nodiscard]] LoopSettings loop_settings(const DeviceProfile& profile, double period_s,
                                         double delay_s);

inline constexpr double damped_in_full_N = 0.2;

/// Damps a sampled spring without ever pulling where the spring pushes: takes B v off its force
/// along its own direction, but leaves at least 0. It never holds back a hand that leaves the wall,
/// and damps nothing along the wall. A spring of less than 0.2 N is damped in proportion, so that
/// nothing jumps where it begins or ends. O(1).
[[nodiscard]] inline Force damped(Force spring, Velocity velocity, double damping_Ns_per_m) {
    const double spring_N = norm(spring);
    if (!(spring_N > 0.0)) return spring;
    const double outward_m_per_s = dot(spring, velocity) / spring_N;
    const double damping = damping_Ns_per_m * std::min(1.0, spring_N / damped_in_full_N);
    const double total_N = std::max(0.0, spring_N - damping * outward_m_per_s);
    return total_N / spring_N * spring;
}

/// The loop's settings by the period and the delay that it measures of itself: averages over a
/// second, worked out again once a second.
class MeasuredLoop {
  public:
    /// Of `tier`, the stiffness and the damping are used. `period_s` > 0 is the planned one.
    MeasuredLoop(const DeviceProfile& profile, double period_s, const TierLimits& tier);

    /// Advances one tick, dt_s > 0 after the one before; a delay that is not >= 0 changes nothing.
    void step(const DeviceProfile& profile, double dt_s, double delay_s);

    [[nodiscard]] double period_s() const { return period_s_; }

    [[nodiscard]] StiffnessBound stiffness_bound() const {
        return {tier_.stiffness_share, settings_.largest_stiffness_N_per_m};
    }

    [[nodiscard]] double damping_Ns_per_m() const {
        return settings_.damping_Ns_per_m + tier_.extra_damping_Ns_per_m;
    }

  private:
    double period_s_;
    TierLimits tier_;
    LoopSettings settings_;
    double measured_period_s_;
    double measured_delay_s_ = 0.0;
    int ticks_to_measure_ = 0;
};

}  // namespace touchline
