#include "haptics/device/plane_spring.h"

#include <algorithm>
#include <cmath>

namespace touchline {

PlaneForce held_to_plane(const PlaneSpring& spring, Force told_D, double off_m,
                         double speed_m_per_s, double share) {
    const bool is_sound = is_finite(told_D) && std::isfinite(off_m) &&
                          std::isfinite(speed_m_per_s) && share >= 0.0 && share <= 1.0;
    if (!is_sound) return {};
    const double back_N =
        -spring.stiffness_N_per_m * off_m - spring.damping_Ns_per_m * speed_m_per_s;
    const double most_N = share * std::min(spring.most_N, spring.limit_N);
    const double across_N = std::clamp(back_N, -most_N, most_N);
    const double left_m = spring.off_plane_m - std::abs(off_m);
    const double on_plane = std::clamp(left_m / (spring.off_plane_m - spring.on_plane_m), 0.0, 1.0);
    const Force wanted = on_plane * told_D;
    const double room_N = std::sqrt(spring.limit_N * spring.limit_N - across_N * across_N);
    const double size_N = norm(wanted);
    return {size_N <= room_N ? wanted : room_N / size_N * wanted, across_N};
}

}  // namespace touchline
