// How the two motors of a five-bar stand to its joints, and the way from one to the other. A motor
// with a controller of its own counts the turns of its shaft and takes torques at its shaft.
// Threads: immutable values and pure functions. No allocation. O(1).
#pragma once

#include "config/types/result.h"
#include "config/types/vec2.h"
#include "haptics/pantograph/profile.h"

namespace touchline {

/// x: the motor of joint 1, y: that of joint 2; turns as the controllers report them.
using ShaftTurns = Vec2<struct ShaftTurn>;
using ShaftTorques = Vec2<struct ShaftNewtonMetre>;

struct JointDrive {
    Turn turn = Turn::counter_clockwise;  // of the joint while the shaft's turns rise
    double ratio = 1.0;                   // turns of the shaft for one of the joint, 0.01 to 100
    double zero_turns = 0.0;              // what is reported at the profile's home, -1000 to 1000
};

struct JointDrives {
    JointDrive joint_1, joint_2;
};

/// Fails in one line if a number is not finite or not in its range.
[[nodiscard]] Result<void> check(const JointDrives& drives);

class DriveFrame {
  public:
    /// `drives` must have passed check().
    DriveFrame(const DeviceProfile& profile, const JointDrives& drives);

    /// Returns home + direction * (turns - zero) / ratio, joint by joint.
    [[nodiscard]] JointAngles joint_angles(ShaftTurns turns) const;

    /// Returns the shafts' turns, whole ones left out, at which the joints are nearest to the
    /// middle of the drawing area. An encoder is absolute over one turn of its shaft, so that all
    /// that differ by whole turns read alike when the power comes on.
    [[nodiscard]] ShaftTurns nearest_the_middle(ShaftTurns turns) const;

    /// Scales both torques together to the profile's limit at the joints, which keeps the
    /// direction, and returns those at the shafts. Zero if one is not finite.
    [[nodiscard]] ShaftTorques shaft_torques(JointTorques torques) const;

    /// Turns back what shaft_torques() made of torques within the limit.
    [[nodiscard]] JointTorques joint_torques(ShaftTorques torques) const;

    /// The shaft turn of `angles`, as nearest_the_middle() would leave it.
    [[nodiscard]] ShaftTurns shaft_turns(JointAngles angles) const;

    /// True if an encoder that is absolute over one turn of its shaft tells the joint's place, for
    /// both: no shaft turns more than once for one turn of its joint.
    [[nodiscard]] bool is_absolute() const;

    [[nodiscard]] const DeviceProfile& profile() const { return profile_; }

  private:
    DeviceProfile profile_;
    JointDrives drives_;
    ShaftTurns middle_;
};

}  // namespace touchline
