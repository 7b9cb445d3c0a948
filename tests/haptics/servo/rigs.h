// A clock, devices and scenes for tests of the servo.
#pragma once

#include "haptics/collision/scene.h"
#include "haptics/device/joint_device.h"
#include "haptics/pantograph/profile.h"
#include "haptics/servo/real_time.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace touchline {

/// Time passes only while somebody sleeps, and by `work_ns` each time somebody looks.
class VirtualClock final : public Clock {
  public:
    [[nodiscard]] std::int64_t now_ns() override { return time_ns_ += work_ns; }

    void sleep_until(std::int64_t t_ns) override { time_ns_ = time_ns_ < t_ns ? t_ns : time_ns_; }

    std::int64_t work_ns = 0;

  private:
    std::int64_t time_ns_ = 0;
};

/// Returns the angles that put the handle of `profile` at p_W.
inline JointAngles angles_at(const DeviceProfile& profile, Position p_W) {
    return inverse(profile.geometry, device_from_picture(profile, p_W)).value();
}

/// Returns what a five-bar tells whose handle is at p_W.
inline DeviceReading reading_at(const DeviceProfile& profile, Position p_W) {
    return reading_of(profile.geometry, angles_at(profile, p_W));
}

/// A device whose handle is where the test puts it, and which remembers what it was told.
class PlacedDevice final : public JointDevice {
  public:
    explicit PlacedDevice(Position p_W)
        : JointDevice(default_profile().geometry), angles(angles_at(default_profile(), p_W)) {}

    [[nodiscard]] std::optional<JointAngles> read_angles(double /*now_s*/) override {
        return angles;
    }

    [[nodiscard]] bool write_torques(JointTorques torques) override {
        written = torques;
        zeros_ = torques == JointTorques{} ? zeros_ + 1 : 0;
        return is_listening && (zeros_ == 0 || zeros_ >= zeros_until_held);
    }

    std::optional<JointAngles> angles;
    JointTorques written;
    bool is_listening = true;
    int zeros_until_held = 1;  // the zero in a row that is reported as held

  private:
    int zeros_ = 0;
};

/// The line y = y_m across the drawing area, from left to right.
inline std::shared_ptr<const Scene> line_scene(double y_m, std::uint64_t version = 1) {
    TactileMap map;
    Outline line;
    line.points = {{-0.05, y_m}, {0.0, y_m}, {0.05, y_m}};
    map.outlines.push_back(line);
    map.version = version;
    return std::make_shared<const Scene>(build_scene(map, {}, 0.005).value());
}

/// A wave of 20 mm wavelength about y = y_m across the drawing area, 512 edges of 0.2 mm.
inline std::shared_ptr<const Scene> wave_scene(double y_m) {
    TactileMap map;
    Outline wave;
    for (int i = 0; i <= 512; ++i) {
        const double x_m = -0.05 + 0.1 * i / 512.0;
        wave.points.push_back({x_m, y_m + 0.001 * std::sin(314.0 * x_m)});
    }
    map.outlines.push_back(wave);
    return std::make_shared<const Scene>(build_scene(map, {}, 0.005).value());
}

}  // namespace touchline
