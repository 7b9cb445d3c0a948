#include "haptics/servo/handle_turn.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double key_rad_per_s = 2.0;
constexpr double most_ahead_rad = 0.35;

}  // namespace

void HandleTurn::step(std::optional<double> device_rad, double wanted_rad, double shape_rad,
                      double dt_s) {
    double next_rad = device_rad.value_or(wanted_rad);
    if (!std::isfinite(next_rad)) next_rad = angle_rad_;
    if (!device_rad) {
        const double most_rad = key_rad_per_s * dt_s;
        const double near_rad =
            std::clamp(next_rad, shape_rad - most_ahead_rad, shape_rad + most_ahead_rad);
        next_rad = std::clamp(near_rad, angle_rad_ - most_rad, angle_rad_ + most_rad);
    }
    turned_rad_ = next_rad - angle_rad_;
    angle_rad_ = next_rad;
    (void)speed_.step({angle_rad_, 0.0}, dt_s);
}

}  // namespace touchline
