#include "tests/lab/stability/controllers.h"

#include <cmath>

namespace touchline::stability {

double FilteredDifference::step(double x_m) {
    velocity_m_per_s_ += share_ * ((x_m - last_m_) / period_s_ - velocity_m_per_s_);
    last_m_ = x_m;
    return velocity_m_per_s_;
}

AdaptiveWindow::AdaptiveWindow(double period_s, double start_m, double encoder_step_m)
    : period_s_(period_s), estimate_(encoder_step_m > 0.0 ? encoder_step_m : 1e-15) {
    for (int i = 0; i < 16; ++i) (void)step(start_m);
}

KalmanVelocity::KalmanVelocity(double period_s, double start_m, double encoder_step_m,
                               double acceleration_m_per_s2)
    : period_s_(period_s),
      noise_m2_(encoder_step_m * encoder_step_m / 12.0),
      acceleration2_(acceleration_m_per_s2 * acceleration_m_per_s2),
      x_m_(start_m) {}

double KalmanVelocity::step(double x_m) {
    const double T = period_s_;
    x_m_ += T * v_m_per_s_;
    xx_ += 2.0 * T * xv_ + T * T * vv_ + acceleration2_ * T * T * T * T / 4.0;
    xv_ += T * vv_ + acceleration2_ * T * T * T / 2.0;
    vv_ += acceleration2_ * T * T;

    const double gain_x = xx_ / (xx_ + noise_m2_);
    const double gain_v = xv_ / (xx_ + noise_m2_);
    const double surprise_m = x_m - x_m_;
    x_m_ += gain_x * surprise_m;
    v_m_per_s_ += gain_v * surprise_m;
    vv_ -= gain_v * xv_;
    xv_ -= gain_v * xx_;
    xx_ -= gain_x * xx_;
    return v_m_per_s_;
}

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
