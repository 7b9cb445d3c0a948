// Kinematics of the planar five-bar linkage. Device frame D: motor 1 at the origin, motor 2 at
// (base, 0), angles counter-clockwise from +x; +y points from the motors to the user, +x to the
// user's left. Only the working branch counts: the tip lies to the left of the line from elbow 1 to
// elbow 2, and both elbows are turned out. Closed form by vector geometry, right everywhere on that
// branch, unlike the published acos version, which fails if the tip is nearer the base than an
// elbow.
// Threads: pure functions; no allocation. O(1).
#pragma once

#include "config/types/vec2.h"

#include <optional>

namespace touchline {

struct Geometry {
    double proximal_m = 0.0;  // l, motor axis to elbow, > 0
    double distal_m = 0.0;    // L, elbow to tip, > 0
    double base_m = 0.0;      // d, between the motor axes, >= 0

    friend bool operator==(const Geometry&, const Geometry&) = default;
};

/// Motion of the tip for a turn of one joint (m/rad).
using TipPerTurn = Vec2<struct MetrePerRadian>;

/// dp_DH / d(joint angles), by columns.
struct Jacobian {
    TipPerTurn joint_1, joint_2;
};

[[nodiscard]] inline bool is_finite(const Jacobian& j) {
    return is_finite(j.joint_1) && is_finite(j.joint_2);
}

struct Pose {
    Position p_DH;
    Jacobian jacobian;  // finite; a column of length 0 is a singular pose
};

/// Returns where the tip is. Returns nothing if the links cannot meet, the angles belong to another
/// branch, or one is not finite.
[[nodiscard]] std::optional<Pose> forward(const Geometry& geometry, JointAngles angles);

/// Returns the joint angles of the working branch that put the tip at p_DH; nothing if it is out of
/// reach or not finite. forward() of the result is p_DH to rounding. Continuous except across the
/// line straight behind each motor.
[[nodiscard]] std::optional<JointAngles> inverse(const Geometry& geometry, Position p_DH);

/// Returns tau = J^T F: the motor torques that make the device push the hand with F (in D).
[[nodiscard]] JointTorques joint_torques(const Jacobian& jacobian, Force force_D);

/// Inverts joint_torques(): returns the force of the tip on the hand, or nothing at a singular
/// pose.
[[nodiscard]] std::optional<Force> tip_force(const Jacobian& jacobian, JointTorques torques);

struct SingularValues {
    double largest = 0.0, smallest = 0.0;
};

/// Returns the singular values of the Jacobian with its columns scaled by the steps of the joints:
/// the tip's motion for one step, in its best and its worst direction. Steps of 1 rad give the
/// Jacobian's own singular values.
[[nodiscard]] SingularValues singular_values(const Jacobian& jacobian,
                                             JointAngles step = {1.0, 1.0});

/// Returns the largest over the smallest singular value, >= 1: how near the pose is to losing a
/// direction; infinite at a singular pose.
[[nodiscard]] double condition(const Jacobian& jacobian);

}  // namespace touchline
