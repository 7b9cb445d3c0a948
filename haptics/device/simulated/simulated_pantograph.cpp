#include "haptics/device/simulated/simulated_pantograph.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <utility>

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

constexpr double finger_lever_m = 0.01;
constexpr double per_turn_m2 = finger_lever_m * finger_lever_m;

Position start_of(const DeviceProfile& profile, const IntendedPath& path) {
    const Position wanted = path.at(0.0).position;
    return inverse(profile.geometry, device_from_picture(profile, wanted)) ? wanted : Position{};
}

constexpr double longest_gap_s = 0.1;

// As the firmware does, except that a torque that is not finite counts as zero.
double motor_torque(double torque_Nm, double limit_Nm) {
    return std::isfinite(torque_Nm) ? std::clamp(torque_Nm, -limit_Nm, limit_Nm) : 0.0;
}

double encoder_reading(double angle_rad, double quantum_rad) {
    return std::floor(angle_rad / quantum_rad) * quantum_rad;
}

}  // namespace

static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

namespace {

Intention at_rest(const WaypointPath::Waypoint& waypoint) {
    return {waypoint.position, {}, waypoint.angle_rad, 0.0};
}

}  // namespace

Intention WaypointPath::at(double t_s) const {
    const auto after = std::ranges::upper_bound(waypoints_, t_s, {}, &Waypoint::t_s);
    if (after == waypoints_.begin()) return at_rest(waypoints_.front());
    if (after == waypoints_.end()) return at_rest(waypoints_.back());
    const Waypoint& from = *std::prev(after);
    const double span_s = after->t_s - from.t_s;
    const auto velocity = along<Velocity>(after->position - from.position, 1.0 / span_s);
    const double turn_rad_per_s = (after->angle_rad - from.angle_rad) / span_s;
    const double since_s = t_s - from.t_s;
    return {from.position + along<Position>(velocity, since_s), velocity,
            from.angle_rad + since_s * turn_rad_per_s, turn_rad_per_s};
}

void MouseHand::move_to(Position position) {
    if (!is_finite(position)) return;
    const auto word = [](double metres) {
        return std::uint64_t{std::bit_cast<std::uint32_t>(static_cast<float>(metres))};
    };
    packed_.store(word(position.x) << 32 | word(position.y), std::memory_order_relaxed);
}

Intention MouseHand::at(double /*t_s*/) const {
    const std::uint64_t packed = packed_.load(std::memory_order_relaxed);
    const auto metres = [](std::uint64_t word) {
        return double{std::bit_cast<float>(static_cast<std::uint32_t>(word))};
    };
    Intention intention;
    intention.position = {metres(packed >> 32), metres(packed & 0xffffffffU)};
    return intention;
}

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

PantographPlant::PantographPlant(const DeviceProfile& profile, const HandModel& hand,
                                 double longest_step_s, std::shared_ptr<const IntendedPath> path)
    : profile_(profile),
      longest_step_s_(longest_step_s),
      path_(std::move(path)),
      dynamics_({profile.mechanics.tip_mass_kg, profile.mechanics.viscous_Ns_per_m,
                 profile.mechanics.coulomb_N},
                hand, start_of(profile, *path_)) {
    if (profile.handle) handle_.emplace(*profile.handle, hand, path_->at(0.0).angle_rad);
}

void PantographPlant::advance(double span_s) {
    if (!(span_s > 0.0)) return;
    const double steps = std::max(1.0, std::ceil(span_s / longest_step_s_ - 1e-6));
    const double h_s = span_s / steps;
    for (int i = 0; i < static_cast<int>(steps); ++i) {
        const Position before = dynamics_.tip().position;
        const Intention intention = path_->at(time_s_);
        dynamics_.step(force_W(), intention, h_s);
        if (handle_) handle_->step(handle_Nm_, intention, h_s);
        time_s_ += h_s;
        // The links stop the tip at their full reach.
        if (!angles()) dynamics_.stop_at(before);
    }
}

std::optional<JointAngles> PantographPlant::angles() const {
    return inverse(profile_.geometry, device_from_picture(profile_, dynamics_.tip().position));
}

Force PantographPlant::force_W() const {
    const auto at = angles();
    const auto pose = at ? forward(profile_.geometry, *at) : std::nullopt;
    const auto force_D = pose ? tip_force(pose->jacobian, torques_) : std::nullopt;
    return force_D ? turned(*force_D) : Force{};
}

SimulatedPantograph::SimulatedPantograph(const DeviceProfile& profile,
                                         const SimulationOptions& options,
                                         std::shared_ptr<const IntendedPath> path)
    : JointDevice(profile.geometry),
      profile_(profile),
      arm_1_scale_error_(options.arm_1_scale_error),
      plant_(profile, options.hand, options.substep_s, std::move(path)) {}

std::optional<JointAngles> SimulatedPantograph::read_angles(double now_s) {
    if (now_s > plant_.time_s()) {
        plant_.skip_to(std::max(plant_.time_s(), now_s - longest_gap_s));
        advance_to(now_s);
    }
    const auto angles = plant_.angles();
    if (!angles) return std::nullopt;
    const double turned_1 = (angles->x - profile_.home.x) * arm_1_scale_error_;
    const JointAngles quantum = encoder_quantum(profile_);
    return JointAngles{encoder_reading(angles->x + turned_1, quantum.x),
                       encoder_reading(angles->y, quantum.y)};
}

std::optional<double> SimulatedPantograph::handle_angle_rad() const {
    if (!plant_.handle()) return std::nullopt;
    return encoder_reading(plant_.handle()->angle_rad(), encoder_quantum_rad(*profile_.handle));
}

void SimulatedPantograph::turn_handle(double torque_Nm) {
    if (profile_.handle) handle_Nm_ = motor_torque(torque_Nm, profile_.handle->torque_limit_Nm);
}

bool SimulatedPantograph::write_torques(JointTorques torques) {
    const double limit = profile_.torque_limit_Nm;
    pending_.push(plant_.time_s() + profile_.mechanics.delay_s,
                  {{motor_torque(torques.x, limit), motor_torque(torques.y, limit)},
                   std::exchange(handle_Nm_, 0.0)});
    return true;
}

void SimulatedPantograph::advance_to(double t_s) {
    while (const auto* const next = pending_.due(t_s)) {
        plant_.advance(next->from_s - plant_.time_s());
        plant_.turn_motors(next->command.torques, next->command.handle_Nm);
        pending_.pop();
    }
    plant_.advance(t_s - plant_.time_s());
    plant_.skip_to(t_s);
}

}  // namespace touchline
