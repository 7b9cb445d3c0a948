#include "tests/lab/stability/wall_controllers.h"

#include "tests/lab/stability/limits.h"
#include "tests/lab/stability/linear_loop.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchline::stability {
namespace {

template <WallController Controller>
ForceLaw law(Controller controller) {
    return [controller](double x_m) mutable { return controller.step(x_m); };
}

ForceLaw low_passed(double stiffness, double damping, const WallLoop& loop, double start_m,
                    double cutoff_Hz) {
    const double share = low_pass_share(cutoff_Hz, loop.period_s);
    return law(DampedWall(stiffness, damping, FilteredDifference(loop.period_s, start_m, share)));
}

ForceLaw observed(double stiffness, const WallLoop& loop, double start_m, double most_damping) {
    return law(EnergyObserverWall(stiffness, loop.period_s, start_m, most_damping));
}

ForceLaw spring(double stiffness, double, const WallLoop&, double) {
    return law(SpringWall(stiffness));
}

ForceLaw difference(double stiffness, double damping, const WallLoop& loop, double start_m) {
    return law(DampedWall(stiffness, damping, FilteredDifference(loop.period_s, start_m)));
}

ForceLaw low_pass(double stiffness, double damping, const WallLoop& loop, double start_m) {
    return low_passed(stiffness, damping, loop, start_m, 100.0);
}

ForceLaw window(double stiffness, double damping, const WallLoop& loop, double start_m) {
    return law(DampedWall(stiffness, damping,
                          AdaptiveWindow(loop.period_s, start_m, loop.encoder_step_m)));
}

constexpr int local_rate = 4;

ForceLaw local_model(double stiffness, double, const WallLoop&, double) {
    return [wall = LocalModelWall(stiffness, local_rate)](double x_m) mutable {
        return wall.step(x_m);
    };
}

/// A damper of more than half the mass per period overshoots.
ForceLaw observer(double stiffness, double, const WallLoop& loop, double start_m) {
    const double mass_kg = loop.tip.mass_kg + (loop.hand.skin ? 0.0 : loop.hand.mass_kg);
    return observed(stiffness, loop, start_m, 0.5 * mass_kg / loop.period_s);
}

ForceLaw observer_30(double stiffness, double, const WallLoop& loop, double start_m) {
    return observed(stiffness, loop, start_m, 30.0);
}

ForceLaw slope_bound(double stiffness, double, const WallLoop& loop, double start_m) {
    const double slope = linear_stiffness(damping_counted(loop), 0.0, loop.period_s, loop.delay_s);
    return law(SlopeBoundWall(stiffness, start_m, slope));
}

}  // namespace

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

double damping_counted(const WallLoop& loop) {
    const double hand = loop.hand.skin
                            ? std::min(loop.hand.skin->damping_Ns_per_m, loop.hand.damping_Ns_per_m)
                            : loop.hand.damping_Ns_per_m;
    return loop.tip.viscous_Ns_per_m + hand;
}

std::span<const Method> methods() {
    static const std::array all = {
        Method{"spring", 0.0, 1, spring},
        Method{"spring + difference", 2.0, 1, difference},
        Method{"spring + LP100", 2.0, 1, low_pass},
        Method{"spring + LP100, B = 5", 5.0, 1, low_pass},
        Method{"spring + FOAW16", 2.0, 1, window},
        Method{"local model", 0.0, local_rate, local_model},
        Method{"energy observer", 0.0, 1, observer},
        Method{"energy observer, cap 30", 0.0, 1, observer_30},
        Method{"slope bound", 0.0, 1, slope_bound},
    };
    return all;
}

const Method& method(std::string_view name) {
    return *std::find_if(methods().begin(), methods().end(),
                         [&](const Method& each) { return each.name == name; });
}

WallLoop force_loop(const Method& method, const WallLoop& loop) {
    WallLoop inner = loop;
    inner.period_s /= method.local_rate;
    inner.delay_s /= method.local_rate;
    return inner;
}

WallTrace render(const Method& method, double stiffness_N_per_m, const WallLoop& loop,
                 const Excitation& excitation, double span_s) {
    const WallLoop inner = force_loop(method, loop);
    const double start_m = quantised(excitation.start_m, loop.encoder_step_m);
    return run(inner, excitation,
               method.make(stiffness_N_per_m, method.damping_Ns_per_m, inner, start_m), span_s);
}

}  // namespace touchline::stability
