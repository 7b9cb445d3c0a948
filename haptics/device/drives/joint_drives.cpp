#include "haptics/device/drives/joint_drives.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchline {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;
constexpr double least_ratio = 0.01, greatest_ratio = 100.0;
constexpr double farthest_zero_turns = 1000.0;

bool is_sound_drive(const JointDrive& drive) {
    return drive.ratio >= least_ratio && drive.ratio <= greatest_ratio &&
           std::abs(drive.zero_turns) <= farthest_zero_turns;
}

// Of the shaft for the joint.
double signed_ratio(const JointDrive& drive) {
    return drive.turn == Turn::counter_clockwise ? drive.ratio : -drive.ratio;
}

double turns_at(const JointDrive& drive, double angle, double home) {
    return drive.zero_turns + signed_ratio(drive) * (angle - home) / full_turn;
}

double angle_at(const JointDrive& drive, double turns, double home) {
    return home + full_turn * (turns - drive.zero_turns) / signed_ratio(drive);
}

}  // namespace

Result<void> check(const JointDrives& drives) {
    if (is_sound_drive(drives.joint_1) && is_sound_drive(drives.joint_2)) return {};
    return failure(
        "the drive of a joint is not as any can be: give a ratio of 0.01 to 100 turns and a zero "
        "of -1000 to 1000 turns");
}

DriveFrame::DriveFrame(const DeviceProfile& profile, const JointDrives& drives)
    : profile_(profile),
      drives_(drives),
      middle_(shaft_turns(inverse(profile.geometry, profile.centre).value_or(profile.home))) {}

JointAngles DriveFrame::joint_angles(ShaftTurns turns) const {
    return {angle_at(drives_.joint_1, turns.x, profile_.home.x),
            angle_at(drives_.joint_2, turns.y, profile_.home.y)};
}

ShaftTurns DriveFrame::shaft_turns(JointAngles angles) const {
    return {turns_at(drives_.joint_1, angles.x, profile_.home.x),
            turns_at(drives_.joint_2, angles.y, profile_.home.y)};
}

ShaftTurns DriveFrame::nearest_the_middle(ShaftTurns turns) const {
    return {turns.x - std::round(turns.x - middle_.x), turns.y - std::round(turns.y - middle_.y)};
}

ShaftTorques DriveFrame::shaft_torques(JointTorques torques) const {
    if (!is_finite(torques)) return {};
    const double largest = std::max(std::abs(torques.x), std::abs(torques.y));
    const double limit_Nm = profile_.torque_limit_Nm;
    const double scale = largest <= limit_Nm ? 1.0 : limit_Nm / largest;
    return {scale * torques.x / signed_ratio(drives_.joint_1),
            scale * torques.y / signed_ratio(drives_.joint_2)};
}

JointTorques DriveFrame::joint_torques(ShaftTorques torques) const {
    return {torques.x * signed_ratio(drives_.joint_1), torques.y * signed_ratio(drives_.joint_2)};
}

bool DriveFrame::is_absolute() const {
    return drives_.joint_1.ratio <= 1.0 && drives_.joint_2.ratio <= 1.0;
}

}  // namespace touchline
