#include "tests/machines/sim/drives/drive_plant.h"

#include <cmath>
#include <utility>

namespace touchline {
namespace {

constexpr double drive_step_s = 1.25e-4;
constexpr double shaft_counts = 16384.0;
constexpr double damping_Nms = 0.01;  // of a damped motor

}  // namespace

DrivePlant::DrivePlant(const DriveTruth& truth, std::shared_ptr<const IntendedPath> path)
    : truth_(truth),
      frame_(truth.profile, truth.drives),
      plant_(truth.profile, truth.hand, drive_step_s, std::move(path)),
      angles_(plant_.angles().value_or(truth.profile.home)) {
    note();
}

void DrivePlant::drive(std::size_t motor, Bridge bridge, double torque_Nm) {
    bridges_[motor] = bridge;
    torques_Nm_[motor] = bridge == Bridge::driven ? torque_Nm : 0.0;
    note();
}

void DrivePlant::note() {
    const ShaftTorques torques{torques_Nm_[0], torques_Nm_[1]};
    if (!changes_.empty() && changes_.back().torques == torques &&
        changes_.back().bridges == bridges_)
        return;
    changes_.push_back({now_s(), torques, bridges_});
}

void DrivePlant::advance(double span_s) {
    const JointAngles before = angles();
    JointTorques torques = frame_.joint_torques({torques_Nm_[0], torques_Nm_[1]});
    if (bridges_[0] == Bridge::damped) torques.x = -damping_Nms * speeds_per_s_.x;
    if (bridges_[1] == Bridge::damped) torques.y = -damping_Nms * speeds_per_s_.y;
    plant_.turn_motors(truth_.have_motors_power ? torques : JointTorques{});
    plant_.advance(span_s);
    plant_.skip_to(plant_.time_s());
    angles_ = angles();
    speeds_per_s_ = (1.0 / span_s) * (angles_ - before);
}

double DrivePlant::shaft_turns(std::size_t motor) const {
    const ShaftTurns turns = frame_.shaft_turns(angles());
    const double true_turns = (motor == 0 ? turns.x : turns.y) + leaps_[motor];
    return std::floor(true_turns * shaft_counts) / shaft_counts;
}

}  // namespace touchline
