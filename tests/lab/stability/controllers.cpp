#include "tests/lab/stability/controllers.h"

#include <cmath>

namespace touchline::stability {

double LocalModelWall::step(double x_m, double wall_m) {
    if (since_geometry_ == 0) known_wall_m_ = wall_m;
    since_geometry_ = (since_geometry_ + 1) % geometry_every_;
    return spring_.step(x_m - known_wall_m_);
}

double EnergyObserverWall::step(double x_m) {
    const double moved_m = x_m - last_m_;
    last_m_ = x_m;
    taken_J_ -= last_N_ * moved_m;
    last_N_ = spring_.step(x_m);
    if (taken_J_ < 0.0 && moved_m != 0.0) {
        const double speed = moved_m / period_s_;
        const double owed = -taken_J_ / (period_s_ * speed * speed);
        last_N_ -= std::min(owed, most_damping_Ns_per_m_) * speed;
    }
    return last_N_;
}

double SlopeBoundWall::step(double x_m) {
    const double most_N = slope_N_per_m_ * std::abs(x_m - last_m_);
    last_m_ = x_m;
    const double change_N = std::clamp(spring_.step(x_m) - last_N_, -most_N, most_N);
    last_N_ = x_m > 0.0 ? last_N_ + change_N : 0.0;
    return last_N_;
}

}  // namespace touchline::stability
