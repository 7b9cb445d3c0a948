// How a unit differs from its device profile, as homing found it and a file keeps it.
// Threads: values.
#pragma once

#include "config/types/vec2.h"

#include <cmath>
#include <cstdint>
#include <optional>

namespace touchline {

/// How a unit's motors, or its encoders, are plugged in, compared with its profile.
struct Plugs {
    bool are_swapped = false;    // each joint is on the other's port
    bool is_1_reversed = false;  // joint 1 turns the other way
    bool is_2_reversed = false;

    friend constexpr bool operator==(const Plugs&, const Plugs&) = default;
};

/// Returns the joints' values for values at the two ports; x is where the profile has joint 1.
template <class Quantity>
[[nodiscard]] constexpr Vec2<Quantity> at_joints(const Plugs& plugs, Vec2<Quantity> at_ports) {
    const Vec2<Quantity> v = plugs.are_swapped ? Vec2<Quantity>{at_ports.y, at_ports.x} : at_ports;
    return {plugs.is_1_reversed ? -v.x : v.x, plugs.is_2_reversed ? -v.y : v.y};
}

/// Converts back.
template <class Quantity>
[[nodiscard]] constexpr Vec2<Quantity> at_ports(const Plugs& plugs, Vec2<Quantity> of_joints) {
    const Vec2<Quantity> v{plugs.is_1_reversed ? -of_joints.x : of_joints.x,
                           plugs.is_2_reversed ? -of_joints.y : of_joints.y};
    return plugs.are_swapped ? Vec2<Quantity>{v.y, v.x} : v;
}

/// Returns 0 to 7, for a message.
[[nodiscard]] constexpr std::uint32_t number_of(const Plugs& plugs) {
    return (plugs.are_swapped ? 1U : 0U) | (plugs.is_1_reversed ? 2U : 0U) |
           (plugs.is_2_reversed ? 4U : 0U);
}

[[nodiscard]] constexpr Plugs plugs_of(std::uint32_t number) {
    return {(number & 1U) != 0, (number & 2U) != 0, (number & 4U) != 0};
}

/// angle = home + offset + scale * (board's reading - its reading at home), joint by joint.
struct Calibration {
    JointAngles offset;    // rad, finite; holds until the board is set up again
    JointAngles stop_off;  // rad: the unit's stop of bent arms, minus the profile's
    double scale = 1.0;    // 0.4 to 1.3: true turn over the turn that both encoders report
    Plugs encoders;
    Plugs motors;
    bool is_measured = false;     // by homing; otherwise all of the above is the profile's
    bool has_all_counts = false;  // the board counts every count that it is told, not half
    std::optional<double> torque_limit_Nm;  // per motor, > 0; nothing: the profile's
};

inline constexpr double least_scale = 0.4, greatest_scale = 1.3;
inline constexpr double greatest_stop_off_rad = 0.1;
inline constexpr double greatest_torque_limit_Nm = 1.0;  // no motor of a desktop device has more

/// Returns whether every number is finite and in its range.
[[nodiscard]] inline bool is_sound(const Calibration& calibration) {
    const auto is_near = [](double off) { return std::abs(off) <= greatest_stop_off_rad; };
    const double limit_Nm = calibration.torque_limit_Nm.value_or(greatest_torque_limit_Nm);
    return is_finite(calibration.offset) && is_near(calibration.stop_off.x) &&
           is_near(calibration.stop_off.y) && calibration.scale >= least_scale &&
           calibration.scale <= greatest_scale && limit_Nm > 0.0 &&
           limit_Nm <= greatest_torque_limit_Nm;
}

}  // namespace touchline
