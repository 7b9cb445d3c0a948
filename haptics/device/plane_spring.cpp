#include "haptics/device/plane_spring.h"

#include "haptics/safety/guards.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

/// 1 up to `all_m` on either side, 0 from `none_m` on, linear in between.
double faded(double off_m, double all_m, double none_m) {
    const double left_m = none_m - std::abs(off_m);
    return left_m > 0.0 ? std::min(left_m / (none_m - all_m), 1.0) : 0.0;
}

/// The spring is bounded before the damping counts, so far from the plane too it is slow.
double across_N(const PlaneSpring& spring, double limit_N, double off_m, double speed_m_per_s,
                double share) {
    const double most_N =
        share * faded(off_m, spring.held_m, spring.let_go_m) * std::min(spring.most_N, limit_N);
    const double back_N = std::clamp(-spring.stiffness_N_per_m * off_m, -most_N, most_N);
    const double wanted_N =
        std::clamp(back_N - spring.damping_Ns_per_m * speed_m_per_s, -most_N, most_N);
    const bool drives = wanted_N * speed_m_per_s > 0.0;
    return drives && is_braked(std::abs(speed_m_per_s)) ? 0.0 : wanted_N;
}

}  // namespace

double share_on_plane(const PlaneSpring& spring, double off_m) {
    return std::isfinite(off_m) ? faded(off_m, spring.on_plane_m, spring.off_plane_m) : 0.0;
}

PlaneForce held_to_plane(const DeviceProfile& profile, Force told_D, double off_m,
                         double speed_m_per_s, double share) {
    const bool is_sound = is_finite(told_D) && std::isfinite(off_m) &&
                          std::isfinite(speed_m_per_s) && share >= 0.0 && share <= 1.0;
    if (!is_sound || !profile.cartesian) return {};
    const PlaneSpring& spring = profile.cartesian->spring;
    const double limit_N = profile.force_limit_N;
    const double held_N = across_N(spring, limit_N, off_m, speed_m_per_s, share);
    const double beside_N = std::sqrt(limit_N * limit_N - held_N * held_N);
    const double room_N = std::min(beside_N, share_on_plane(spring, off_m) * limit_N);
    const double size_N = norm(told_D);
    return {size_N <= room_N ? told_D : room_N / size_N * told_D, held_N};
}

}  // namespace touchline
