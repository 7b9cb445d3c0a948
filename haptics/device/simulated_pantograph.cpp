#include "haptics/device/simulated_pantograph.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double longest_gap_s = 0.1;

Position start_of(const DeviceProfile& profile, const IntendedPath& path) {
    const Position wanted = path.at(0.0).position;
    return inverse(profile.geometry, device_from_picture(profile, wanted)) ? wanted : Position{};
}

TipParameters tip_of(const MechanicsProfile& mechanics) {
    return {mechanics.tip_mass_kg, mechanics.viscous_Ns_per_m, mechanics.coulomb_N};
}

// As the firmware does, but that a torque that is not finite counts as zero.
double motor_torque(double torque_Nm, double limit_Nm) {
    return std::isfinite(torque_Nm) ? std::clamp(torque_Nm, -limit_Nm, limit_Nm) : 0.0;
}

double encoder_reading(double angle_rad, double quantum_rad) {
    return std::floor(angle_rad / quantum_rad) * quantum_rad;
}

}  // namespace

SimulatedPantograph::SimulatedPantograph(const DeviceProfile& profile,
                                         const SimulationOptions& options,
                                         std::shared_ptr<const IntendedPath> path)
    : profile_(profile),
      options_(options),
      path_(std::move(path)),
      dynamics_(tip_of(profile.mechanics), options.hand, start_of(profile, *path_)) {}

std::optional<JointAngles> SimulatedPantograph::read_angles(double now_s) {
    if (now_s > time_s_) {
        time_s_ = std::max(time_s_, now_s - longest_gap_s);
        advance_to(now_s);
    }
    const auto angles =
        inverse(profile_.geometry, device_from_picture(profile_, dynamics_.tip().position));
    if (!angles) return std::nullopt;
    const double turned_1 = (angles->x - profile_.home.x) * options_.arm_1_scale_error;
    const JointAngles quantum = encoder_quantum(profile_);
    return JointAngles{encoder_reading(angles->x + turned_1, quantum.x),
                       encoder_reading(angles->y, quantum.y)};
}

bool SimulatedPantograph::write_torques(JointTorques torques) {
    if (pending_count_ == pending_.size()) --pending_count_;  // the newest is overtaken
    const std::size_t slot = (first_pending_ + pending_count_) % pending_.size();
    const double limit = profile_.torque_limit_Nm;
    pending_[slot] = {time_s_ + profile_.mechanics.delay_s,
                      {motor_torque(torques.x, limit), motor_torque(torques.y, limit)}};
    ++pending_count_;
    return true;
}

void SimulatedPantograph::advance_to(double t_s) {
    while (pending_count_ > 0 && pending_[first_pending_].from_s <= t_s) {
        const Command& command = pending_[first_pending_];
        integrate(command.from_s - time_s_);
        acting_ = command.torques;
        first_pending_ = (first_pending_ + 1) % pending_.size();
        --pending_count_;
    }
    integrate(t_s - time_s_);
    time_s_ = t_s;
}

void SimulatedPantograph::integrate(double span_s) {
    if (!(span_s > 0.0)) return;
    const double steps = std::max(1.0, std::ceil(span_s / options_.substep_s - 1e-6));
    const double h_s = span_s / steps;
    for (int i = 0; i < static_cast<int>(steps); ++i) {
        const Position before = dynamics_.tip().position;
        dynamics_.step(force_W(), path_->at(time_s_), h_s);
        time_s_ += h_s;
        // The links stop the tip where they end.
        if (!inverse(profile_.geometry, device_from_picture(profile_, dynamics_.tip().position))) {
            dynamics_.stop_at(before);
        }
    }
}

Force SimulatedPantograph::force_W() const {
    const Position p_DH = device_from_picture(profile_, dynamics_.tip().position);
    const auto angles = inverse(profile_.geometry, p_DH);
    const auto pose = angles ? forward(profile_.geometry, *angles) : std::nullopt;
    const auto force_D = pose ? tip_force(pose->jacobian, acting_) : std::nullopt;
    return force_D ? turned(*force_D) : Force{};
}

}  // namespace touchline
