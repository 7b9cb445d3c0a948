#include "haptics/servo/loop_settings.h"

namespace touchline {
namespace {

constexpr double light_hand_Ns_per_m = 1.0;
constexpr double finest_wall_N_per_m = 1500.0;
constexpr double fast_loop_s = 5.5e-4;  // 2 kHz, with some lateness
constexpr double measuring_s = 1.0;
constexpr double longest_period_s = 0.02;  // a longer one is a pause, not the loop's period

}  // namespace

LoopSettings loop_settings(const DeviceProfile& profile, double period_s, double delay_s) {
    const MechanicsProfile& tip = profile.mechanics;
    const double lag_s = 0.5 * period_s + std::max(delay_s, period_s);
    const double encoder_N_per_m = 2.0 * tip.coulomb_N / encoder_step_m(profile);
    LoopSettings settings;
    settings.damping_Ns_per_m = period_s < fast_loop_s ? 2.0 : 1.5;
    settings.stiffness_N_per_m =
        std::min({0.95 * (tip.viscous_Ns_per_m + light_hand_Ns_per_m) / lag_s, encoder_N_per_m,
                  finest_wall_N_per_m});
    const double damped_N_per_m = 0.9 * (tip.viscous_Ns_per_m + settings.damping_Ns_per_m) / lag_s;
    settings.largest_stiffness_N_per_m =
        std::max(settings.stiffness_N_per_m,
                 std::min({damped_N_per_m, encoder_N_per_m, finest_wall_N_per_m}));
    return settings;
}

MeasuredLoop::MeasuredLoop(const DeviceProfile& profile, double period_s, const TierLimits& tier)
    : period_s_(period_s),
      tier_(tier),
      settings_(loop_settings(profile, period_s, 0.0)),
      measured_period_s_(period_s) {}

void MeasuredLoop::step(const DeviceProfile& profile, double dt_s, double delay_s) {
    const double weight = std::min(1.0, dt_s / measuring_s);
    measured_period_s_ += weight * (std::min(dt_s, longest_period_s) - measured_period_s_);
    if (delay_s >= 0.0)
        measured_delay_s_ += weight * (std::min(delay_s, longest_period_s) - measured_delay_s_);
    if (--ticks_to_measure_ > 0) return;
    ticks_to_measure_ = static_cast<int>(measuring_s / period_s_);
    settings_ = loop_settings(profile, measured_period_s_, measured_delay_s_);
}

}  // namespace touchline
