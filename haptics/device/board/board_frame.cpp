#include "haptics/device/board/board_frame.h"

#include "config/types/angle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchline {
namespace {

constexpr double most_counts = 1e6;  // many turns of any encoder; no arm turns one

// The board keeps only the whole part. Half a count more gives the same count again, however the
// float was rounded.
double within_count(double raw_deg, double quantum_deg) {
    return raw_deg + std::copysign(0.5 * quantum_deg, raw_deg);
}

// As the board computes it.
double whole_counts(float offset_deg, double counts_per_turn) {
    return 360.0 * std::trunc(static_cast<double>(offset_deg) * counts_per_turn / 360.0) /
           counts_per_turn;
}

// To a thousandth, or as closely as a float of degrees can tell.
bool is_whole(double raw_deg, double quantum_deg) {
    const double counts = raw_deg / quantum_deg;
    const double tolerance =
        1e-3 + 2.0 * static_cast<double>(std::numeric_limits<float>::epsilon()) * std::abs(counts);
    return std::abs(counts) <= most_counts && std::abs(counts - std::round(counts)) <= tolerance;
}

double handle_quantum_deg(const TurningHandle& handle) {
    return degrees(encoder_quantum_rad(handle));
}

// Puts the values of the two ports in the order of the joints, or the other way round: it is its
// own inverse.
template <class Out, class In>
Vec2<Out> reordered(Vec2<In> v, bool is_crossed, double scale) {
    return is_crossed ? Vec2<Out>{scale * v.y, scale * v.x} : Vec2<Out>{scale * v.x, scale * v.y};
}

}  // namespace

DeviceProfile calibrated(const DeviceProfile& profile, const Calibration& calibration) {
    DeviceProfile unit = profile;
    if (calibration.torque_limit_Nm) unit.torque_limit_Nm = *calibration.torque_limit_Nm;
    if (calibration.has_all_counts) {
        unit.counts_per_turn = profile.wiring.told_per_count * profile.counts_per_turn;
        unit.wiring.told_per_count = 1.0;
    }
    return unit;
}

BoardFrame::BoardFrame(const DeviceProfile& profile, const Calibration& calibration)
    : profile_(profile),
      calibration_(calibration),
      unit_(calibrated(profile, calibration)),
      is_joint_1_on_port_2_(profile.wiring.joint_1.port == 2),
      quantum_(reordered<PortDegree>(encoder_quantum(unit_), is_joint_1_on_port_2_, degrees(1.0))) {
}

BoardSetUp BoardFrame::set_up_at_home() const {
    const auto home = reordered<PortDegree>(profile_.home, is_joint_1_on_port_2_, degrees(1.0));
    const auto told = reordered<PortDegree>(unit_.counts_per_turn, is_joint_1_on_port_2_,
                                            unit_.wiring.told_per_count);
    const Turn turn_1 = profile_.wiring.joint_1.turn;
    const Turn turn_2 = profile_.wiring.joint_2.turn;
    BoardSetUp set_up;
    set_up.turns = {is_joint_1_on_port_2_ ? turn_2 : turn_1,
                    is_joint_1_on_port_2_ ? turn_1 : turn_2};
    set_up.offsets_deg = {static_cast<float>(home.x), static_cast<float>(home.y)};
    set_up.counts_told = {static_cast<float>(told.x), static_cast<float>(told.y)};
    if (const auto& handle = profile_.handle) {
        const double handle_told = handle->counts_per_turn * unit_.wiring.told_per_count;
        set_up.handle = HandlePort{handle->turn, 0.0F, static_cast<float>(handle_told)};
    }
    return set_up;
}

BoardSetUp BoardFrame::set_up_at(PortAngles raw, double handle_deg) const {
    BoardSetUp set_up = set_up_at_home();
    set_up.offsets_deg = {static_cast<float>(within_count(raw.x, quantum_.x)),
                          static_cast<float>(within_count(raw.y, quantum_.y))};
    if (set_up.handle) {
        set_up.handle->offset_deg =
            static_cast<float>(within_count(handle_deg, handle_quantum_deg(*profile_.handle)));
    }
    return set_up;
}

PortAngles BoardFrame::home_reading() const {
    const BoardSetUp set_up = set_up_at_home();
    const double told = unit_.wiring.told_per_count;
    return {whole_counts(set_up.offsets_deg[0], static_cast<double>(set_up.counts_told[0]) / told),
            whole_counts(set_up.offsets_deg[1], static_cast<double>(set_up.counts_told[1]) / told)};
}

JointAngles BoardFrame::joint_angles(PortAngles raw) const {
    const auto turned =
        reordered<Radian>(raw - home_reading(), is_joint_1_on_port_2_, radians(1.0));
    return profile_.home + calibration_.offset +
           calibration_.scale * at_joints(calibration_.encoders, turned);
}

PortAngles BoardFrame::reading_at(JointAngles angles) const {
    const JointAngles turned =
        (1.0 / calibration_.scale) * (angles - profile_.home - calibration_.offset);
    return home_reading() + reordered<PortDegree>(at_ports(calibration_.encoders, turned),
                                                  is_joint_1_on_port_2_, degrees(1.0));
}

bool BoardFrame::is_whole_counts(PortAngles raw, double handle_deg) const {
    return is_whole(raw.x, quantum_.x) && is_whole(raw.y, quantum_.y) &&
           (!has_handle() || is_whole(handle_deg, handle_quantum_deg(*profile_.handle)));
}

int BoardFrame::motor_port(int joint) const {
    return (joint == 1) != (is_joint_1_on_port_2_ != calibration_.motors.are_swapped) ? 1 : 2;
}

BoardFrame BoardFrame::with_all_counts() const {
    Calibration calibration = calibration_;
    calibration.has_all_counts = true;
    return {profile_, calibration};
}

std::optional<double> BoardFrame::handle_torque_Nm(double torque_Nm) const {
    if (!has_handle()) return std::nullopt;
    const double limit_Nm = profile_.handle->torque_limit_Nm;
    return std::isfinite(torque_Nm) ? std::clamp(torque_Nm, -limit_Nm, limit_Nm) : 0.0;
}

PortTorques BoardFrame::port_torques(JointTorques torques) const {
    if (!is_finite(torques)) return {};
    const double largest = std::max(std::abs(torques.x), std::abs(torques.y));
    const double limit_Nm = unit_.torque_limit_Nm;
    const double scale = largest <= limit_Nm ? 1.0 : limit_Nm / largest;
    return reordered<PortNewtonMetre>(at_ports(calibration_.motors, torques), is_joint_1_on_port_2_,
                                      scale);
}

}  // namespace touchline
