#include "haptics/device/handle_dynamics.h"

#include <cmath>

namespace touchline {
namespace {

constexpr double finger_lever_m = 0.01;
constexpr double per_turn_m2 = finger_lever_m * finger_lever_m;

}  // namespace

void HandleDynamics::step(double torque_Nm, const Intention& intention, double h_s) {
    const double inertia_kg_m2 = handle_.inertia_kg_m2 + per_turn_m2 * hand_.mass_kg;
    const double damping_Nms = per_turn_m2 * hand_.damping_Ns_per_m;
    const double spring_Nm =
        per_turn_m2 * hand_.stiffness_N_per_m * (intention.angle_rad - angle_rad_);
    const double push_Nm = torque_Nm + spring_Nm + damping_Nms * intention.turn_rad_per_s;
    const double share_s = h_s / inertia_kg_m2;
    const double damped_rad_per_s = (speed_rad_per_s_ + share_s * push_Nm) /
                                    (1.0 + share_s * (damping_Nms + handle_.viscous_Nms));
    // Friction takes away at most the present speed, so a stopped handle stays where it is.
    const double friction_rad_per_s = share_s * handle_.coulomb_Nm;
    const double left_rad_per_s = std::abs(damped_rad_per_s) - friction_rad_per_s;
    const double next_rad_per_s =
        left_rad_per_s > 0.0 ? std::copysign(left_rad_per_s, damped_rad_per_s) : 0.0;
    angle_rad_ += 0.5 * h_s * (speed_rad_per_s_ + next_rad_per_s);
    speed_rad_per_s_ = next_rad_per_s;
}

}  // namespace touchline
