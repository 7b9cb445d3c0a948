// The known devices, by name, and the two frames: picture W and device D.
// Threads: immutable values.
#pragma once

#include "config/types/result.h"
#include "config/types/tactile_map.h"
#include "config/types/vec2.h"
#include "haptics/pantograph/kinematics.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace touchline {

/// The mechanics that a simulation of the device and the guards of its force start from. Estimates,
/// because no maker publishes them.
struct MechanicsProfile {
    double tip_mass_kg = 0.05;      // effective, at the tip
    double viscous_Ns_per_m = 0.1;  // at the tip
    double coulomb_N = 0.05;        // at the tip
    double delay_s = 0.0;           // from writing a torque to its effect
    // What a motor bears forever, as a share of its limit, and how slowly it warms. By users'
    // reports, the share gives about 1 N on the hand if 1.7 N is the most.
    double continuous_torque = 0.6;
    double warming_s = 60.0;
};

/// The direction that a motor or an encoder counts as positive, as the board numbers it.
enum class Turn : std::uint8_t { clockwise = 0, counter_clockwise = 1 };

/// The ports of a joint's motor and encoder, and their directions.
struct JointWiring {
    int port = 1;  // 1 or 2
    Turn turn = Turn::counter_clockwise;
};

struct BoardWiring {
    JointWiring joint_1, joint_2;  // on different ports
    double told_per_count = 1.0;   // counts a turn that the board is told, over those it resolves
};

/// A handle that turns about its own axis, with a motor and an encoder on port 3: a person who
/// holds a shape turns it and feels its torque. Its mechanics are estimates, like the tip's.
struct TurningHandle {
    double counts_per_turn = 0.0;  // that the board resolves
    double torque_limit_Nm = 0.0;  // on the hand, at full duty
    Turn turn = Turn::counter_clockwise;
    double inertia_kg_m2 = 0.0;  // of the handle and its motor
    double viscous_Nms = 0.0;
    double coulomb_Nm = 0.0;
};

/// Where stops hold the arms, as a person finds it. away: the handle pushed towards the motors.
/// towards: pulled towards the person. sideways: the arms straight out to both sides.
enum class StopPlace : std::uint8_t { away, towards, sideways };

/// The second stop, at which homing is checked.
struct CheckStop {
    JointAngles angles;  // rad
    StopPlace place = StopPlace::towards;
};

/// What holds the handle of a device with three axes to the drawing plane, and where the force in
/// the plane ends (haptics/device/plane_spring.h). All 0: there is no force at all.
struct PlaneSpring {
    double stiffness_N_per_m = 0.0;
    double damping_Ns_per_m = 0.0;
    double most_N = 0.0;       // of spring and damping together
    double on_plane_m = 0.0;   // all of the plane's force up to here, either side ...
    double off_plane_m = 0.0;  // ... none from here on, > on_plane_m
    double held_m = 0.0;       // all of what holds it to the plane up to here ...
    double let_go_m = 0.0;     // ... none from here on, > held_m
};

/// A device that tells places and takes forces, and keeps its arms, encoders and motors to itself.
struct CartesianDevice {
    double step_m = 1e-4;       // the smallest motion that it tells, > 0
    double continuous_N = 1.0;  // the force that it bears forever, > 0
    PlaneSpring spring;
};

/// Of a Cartesian device links, counts, torque limit, home, wiring and stops mean nothing.
struct DeviceProfile {
    std::string_view name;
    Geometry geometry;
    JointAngles counts_per_turn;  // encoder counts that the board resolves per turn of each joint
    double torque_limit_Nm = 0.123;  // of one motor at full duty
    JointAngles home;                // angles of the home pose (rad)
    Area area;                       // drawing area
    Position centre;                 // of the drawing area, in D
    double force_limit_N = 3.0;      // on the hand
    double bandwidth_Hz = 100.0;     // faster forces are not felt as commanded
    MechanicsProfile mechanics;
    BoardWiring wiring;
    StopPlace home_place = StopPlace::away;
    CheckStop check;
    std::optional<TurningHandle> handle;  // nothing: the handle does not turn
    double other_counts_per_turn = 0.0;   // some units of this kind have these counts; 0: none do
    std::optional<CartesianDevice> cartesian = std::nullopt;  // nothing: a five-bar
};

/// True for a five-bar, whose motors are told torques.
[[nodiscard]] constexpr bool has_joints(const DeviceProfile& profile) {
    return !profile.cartesian;
}

/// 2diy-gen3.1 (the default), the same stopped at 172/8 and 180/0 degrees, 2diy-gen3, 2diy-gen2,
/// the same stopped at 240/-60, haplet, mk2, gen3.1-turning.
[[nodiscard]] std::span<const DeviceProfile> device_profiles();

/// cartesian, a made-up one for the simulation; inverse3, its drawing area level before its foot.
[[nodiscard]] std::span<const DeviceProfile> cartesian_profiles();

/// open-five-bar: arms of the size of the mk2's, which one builds, on motors with controllers of
/// their own. No board drives it, so it is no kind that a person chooses for a board.
[[nodiscard]] const DeviceProfile& open_five_bar();

[[nodiscard]] const DeviceProfile& default_profile();

/// Of the five-bars; the error lists their names.
[[nodiscard]] Result<DeviceProfile> find_profile(std::string_view name);

/// Of all there are; the error is that of find_profile().
[[nodiscard]] Result<DeviceProfile> find_device_profile(std::string_view name);

/// Returns the named profile, or the default one if the name is not known; for uses where any
/// profile will do.
[[nodiscard]] DeviceProfile profile_or_default(std::string_view name);

/// W is D turned by 180 degrees about the centre of the drawing area, so each function is its own
/// inverse.
[[nodiscard]] constexpr Position device_from_picture(const DeviceProfile& profile, Position p_W) {
    return profile.centre - p_W;
}

[[nodiscard]] constexpr Position picture_from_device(const DeviceProfile& profile, Position p_D) {
    return profile.centre - p_D;
}

/// Free vectors change sign between W and D.
template <class Quantity>
[[nodiscard]] constexpr Vec2<Quantity> turned(Vec2<Quantity> v) {
    return -v;
}

/// Returns the turn of each joint for one encoder count (rad).
[[nodiscard]] JointAngles encoder_quantum(const DeviceProfile& profile);

/// Returns the turn of a handle for one count of its encoder (rad).
[[nodiscard]] double encoder_quantum_rad(const TurningHandle& handle);

/// Returns the smallest motion that the device can surely tell: of a five-bar, the tip's step for
/// one encoder count, in the pose's worst direction, at the centre of the drawing area.
[[nodiscard]] double encoder_step_m(const DeviceProfile& profile);

}  // namespace touchline
