#include "haptics/device/tip_dynamics.h"

#include <algorithm>

namespace touchline {
namespace {

/// What acts on a mass: the forces that do not depend on its own velocity, and the two effects that
/// do.
struct Load {
    Force force;
    double damping_Ns_per_m = 0.0;
    double coulomb_N = 0.0;
};

void integrate(MassState& mass, double mass_kg, const Load& load, double h_s) {
    const Velocity pushed = mass.velocity + along<Velocity>(load.force, h_s / mass_kg);
    const Velocity damped = 1.0 / (1.0 + h_s * load.damping_Ns_per_m / mass_kg) * pushed;
    // Friction takes away at most the present velocity, so a stopped tip stays where it is.
    const double speed = norm(damped);
    const double friction = h_s * load.coulomb_N / mass_kg;
    const Velocity next = speed > friction ? (1.0 - friction / speed) * damped : Velocity{};
    mass.position += along<Position>(mass.velocity + next, 0.5 * h_s);
    mass.velocity = next;
}

Force spring_and_damper(Position stretch, double stiffness_N_per_m, Velocity other_end,
                        double damping_Ns_per_m) {
    return along<Force>(stretch, stiffness_N_per_m) + along<Force>(other_end, damping_Ns_per_m);
}

}  // namespace

void TipDynamics::step(Force force, const Intention& intention, double h_s) {
    const auto arm_on = [&](const MassState& mass) {
        return spring_and_damper(intention.position - mass.position, hand_.stiffness_N_per_m,
                                 intention.velocity, hand_.damping_Ns_per_m);
    };
    if (!hand_.skin) {
        const Load load{force + arm_on(tip_state_), tip_.viscous_Ns_per_m + hand_.damping_Ns_per_m,
                        tip_.coulomb_N};
        integrate(tip_state_, tip_.mass_kg + hand_.mass_kg, load, h_s);
        return;
    }
    const HandModel::Skin& skin = *hand_.skin;
    const Position stretch = hand_state_.position - tip_state_.position;
    const Load on_tip{force + spring_and_damper(stretch, skin.stiffness_N_per_m,
                                                hand_state_.velocity, skin.damping_Ns_per_m),
                      tip_.viscous_Ns_per_m + skin.damping_Ns_per_m, tip_.coulomb_N};
    const Load on_hand{
        arm_on(hand_state_) + spring_and_damper(-stretch, skin.stiffness_N_per_m,
                                                tip_state_.velocity, skin.damping_Ns_per_m),
        hand_.damping_Ns_per_m + skin.damping_Ns_per_m, 0.0};
    integrate(tip_state_, tip_.mass_kg, on_tip, h_s);
    integrate(hand_state_, hand_.mass_kg, on_hand, h_s);
}

void TipDynamics::stop_at(Position position) {
    tip_state_ = {position, {}};
}

}  // namespace touchline
