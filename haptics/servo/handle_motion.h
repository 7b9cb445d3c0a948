// Where the handle is, how fast it moves and how far it is turned, from what the device tells.
// Threads: one, the servo's. Plain values.
#pragma once

#include "config/types/vec2.h"
#include "haptics/collision/scene.h"
#include "haptics/device/force_device.h"
#include "haptics/pantograph/kinematics.h"
#include "haptics/pantograph/profile.h"
#include "haptics/safety/guards.h"
#include "haptics/servo/exchange.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace touchline {

/// Estimates the handle's velocity from positions that jump by encoder steps, by first-order
/// adaptive windowing (Janabi-Sharifi, Hayward, Chen 2000), each axis on its own.
class VelocityEstimate {
  public:
    /// `noise_m` > 0: how far a sample may lie from the truth, which is one encoder step.
    explicit VelocityEstimate(double noise_m) : noise_m_(noise_m) {}

    /// Returns the slope from the newest sample back over the longest window, at most 16 periods,
    /// whose line passes all samples between within the noise. Returns 0 for the first sample and
    /// for one that is not finite, which also clears all others. `dt_s` > 0 is the time since the
    /// last sample.
    Velocity step(Position position, double dt_s);

    void reset() { count_ = 0; }

    [[nodiscard]] Velocity velocity() const { return velocity_; }

    /// Whether a copy made from bytes may be stepped.
    [[nodiscard]] bool is_sound() const {
        return newest_ < samples_.size() && count_ <= samples_.size();
    }

  private:
    static constexpr std::size_t window = 16;

    struct Sample {
        Position position;
        double dt_s = 0.0;  // since the sample before
    };

    [[nodiscard]] const Sample& back(std::size_t i) const {
        return samples_[(newest_ + samples_.size() - i) % samples_.size()];
    }

    double noise_m_;
    std::array<Sample, window + 1> samples_{};
    std::size_t newest_ = 0;
    std::size_t count_ = 0;
    Velocity velocity_;
};

/// How far the shape in the hand is turned: by a handle that turns, else by keys or a knob.
class HandleTurn {
  public:
    /// `count_rad` > 0: one count of the handle's encoder; any value if it has none.
    explicit HandleTurn(double count_rad) : speed_(count_rad) {}

    /// Advances one tick of dt_s > 0. Takes `device_rad` if the handle turns. Otherwise the angle
    /// follows `wanted_rad` at 2 rad/s, but runs no further ahead of the shape, at `shape_rad`,
    /// than a hand that feels it stuck would turn. Values that are not finite change nothing.
    void step(std::optional<double> device_rad, double wanted_rad, double shape_rad, double dt_s);

    [[nodiscard]] double angle_rad() const { return angle_rad_; }

    /// The turn in the last tick.
    [[nodiscard]] double turned_rad() const { return turned_rad_; }

    [[nodiscard]] double rad_per_s() const { return speed_.velocity().x; }

    /// Whether a copy made from bytes may be stepped.
    [[nodiscard]] bool is_sound() const { return speed_.is_sound(); }

  private:
    double angle_rad_ = 0.0;
    double turned_rad_ = 0.0;
    VelocityEstimate speed_;  // the angle's speed, as metres at 1 m
};

struct StepInput {
    double now_s = 0.0;                    // since the servo started
    std::uint64_t missed_ticks = 0;        // total so far
    std::optional<DeviceReading> reading;  // nothing if the device did not answer
    ServoCommands commands;
    const Scene* scene = nullptr;  // wanted; must live until ServoStep::scene() is another one
    double delay_s = 0.0;          // from reading the device to the command's effect, as measured
    // The share of the force that is let through, 0 ... 1. At 0 force is off, and it comes back by
    // the arm rule.
    double force_share = 1.0;
};

/// The handle in a tick.
struct HandleReading {
    bool is_placed = false;            // p_WH is known; a jump is not believed at once
    std::optional<Jacobian> jacobian;  // of a joint device that is placed
    bool has_jumped = false;           // to where it cannot have moved
    double silent_s = 0.0;             // since the device last answered
    double dt_s = 0.0;                 // since the tick before
    Position p_WH;                     // the last known
    Position moved;                    // in a tick that is placed: since the one before
    Velocity velocity;
    double angle_rad = 0.0;
    double turned_rad = 0.0;  // in the last tick that was placed
    double rad_per_s = 0.0;
};

class HandleMotion {
  public:
    explicit HandleMotion(const DeviceProfile& profile);

    /// Advances one tick, `dt_s` > 0 after the one before and `period_s` > 0 by plan. Of a handle
    /// that does not turn, the angle follows the commands, near the held shape at `shape_rad`. A
    /// velocity that the device measured is taken if the positions bear it out to a quarter and
    /// 0.05 m/s, else that of the positions. A place that is not new tells nothing: the handle is
    /// where it was, and guard and velocity take the next one for as much older. One that was late
    /// may be older than it seems, so the way to the next one counts as longer by what that is less
    /// late: no hand is seen faster than it was. One that is not finite is none.
    [[nodiscard]] HandleReading step(const DeviceProfile& profile, const StepInput& input,
                                     std::optional<double> shape_rad, double period_s, double dt_s);

    /// Whether a copy made from bytes may be stepped.
    [[nodiscard]] bool is_sound() const { return velocity_.is_sound() && turn_.is_sound(); }

  private:
    void judge(const StepInput& input, HandleReading& handle);
    [[nodiscard]] Velocity believed(const std::optional<DeviceReading>& told) const;

    PositionGuard guard_;
    std::optional<Position> p_DH_;      // last one used
    std::optional<Jacobian> jacobian_;  // there
    double silent_s_ = 0.0;
    VelocityEstimate velocity_;
    HandleTurn turn_;
    double unseen_s_ = 0.0;  // since the newest place came, in ticks that are placed
    double late_s_ = 0.0;    // of that place
    Position p_WH_;          // last known
};

}  // namespace touchline
