#include "haptics/device/simulated_pantograph.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchline {
namespace {

constexpr double longest_gap_s = 0.1;

// As the firmware does, except that a torque that is not finite counts as zero.
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
    if (pending_count_ == pending_.size()) --pending_count_;  // the newest gives way
    const std::size_t slot = (first_pending_ + pending_count_) % pending_.size();
    const double limit = profile_.torque_limit_Nm;
    pending_[slot] = {plant_.time_s() + profile_.mechanics.delay_s,
                      {motor_torque(torques.x, limit), motor_torque(torques.y, limit)},
                      std::exchange(handle_Nm_, 0.0)};
    ++pending_count_;
    return true;
}

void SimulatedPantograph::advance_to(double t_s) {
    while (pending_count_ > 0 && pending_[first_pending_].from_s <= t_s) {
        const TimedTorques& command = pending_[first_pending_];
        plant_.advance(command.from_s - plant_.time_s());
        plant_.turn_motors(command.torques, command.handle_Nm);
        first_pending_ = (first_pending_ + 1) % pending_.size();
        --pending_count_;
    }
    plant_.advance(t_s - plant_.time_s());
    plant_.skip_to(t_s);
}

}  // namespace touchline
