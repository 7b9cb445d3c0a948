#include "haptics/resolution/shape_level_rule.h"

#include <cmath>

namespace touchline {

double ShapeSpeed::step(Position handle, double angle_rad, double dt_s) {
    const double share = low_pass_share(dt_s);
    const Position moved = has_last_ ? handle - last_ : Position{};
    const double turned_rad = has_last_ ? angle_rad - last_angle_rad_ : 0.0;
    last_ = handle;
    last_angle_rad_ = angle_rad;
    has_last_ = true;
    low_pass_ += share * (along<Velocity>(moved, 1.0 / dt_s) - low_pass_);
    low_pass_rad_per_s_ += share * (turned_rad / dt_s - low_pass_rad_per_s_);
    const double fastest = norm(low_pass_) + std::abs(low_pass_rad_per_s_) * r_max_m_;
    return peak_.step(fastest * fastest, dt_s);
}

}  // namespace touchline
