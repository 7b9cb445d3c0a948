#include "haptics/device/joint_device.h"

namespace touchline {

DeviceReading reading_of(const Geometry& geometry, JointAngles angles) {
    DeviceReading reading;
    reading.joints = angles;
    if (const auto pose = forward(geometry, angles)) {
        reading.p_D = pose->p_DH;
        reading.jacobian = pose->jacobian;
    }
    return reading;
}

std::optional<DeviceReading> JointDevice::read(double now_s) {
    const auto angles = read_angles(now_s);
    if (!angles) return std::nullopt;
    DeviceReading reading = reading_of(geometry_, *angles);
    reading.freshness = freshness();
    reading.handle_rad = handle_angle_rad();
    return reading;
}

bool JointDevice::write(const DeviceCommand& command) {
    turn_handle(command.handle_Nm);
    return write_torques(command.torques);
}

}  // namespace touchline
