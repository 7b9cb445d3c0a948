// A pantograph whose two motors have controllers of their own: the driver over any MotorPair. It
// writes once at the end of a tick and reads the answers at the next. If anything goes wrong, the
// torque goes first, and no angles are given until both controllers were armed anew. If this
// computer dies, the controllers' own watchdogs let the motors go (motor_pair.h, watchdog_s).
#pragma once

#include "config/types/result.h"
#include "haptics/device/drives/motor_pair.h"
#include "haptics/device/joint_device.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace touchline {

/// From good to bad. setting_up: the controllers are being armed, and force is zero. jumped: the
/// angles leapt, until accept_position(). refused: a controller may not or cannot work, until
/// open(). lost: unplugged, or silent for good.
enum class DriveState : std::uint8_t { closed, ready, setting_up, jumped, refused, lost };

/// What the driver saw, for the operator and the log. Counts start when it is made.
struct DriveReport {
    DriveState state = DriveState::closed;
    bool is_position_doubtful = false;  // the encoders do not tell the place: go home
    bool was_torque_not_finite = false;
    MotorTrouble trouble;
    std::uint64_t replies = 0;
    std::uint64_t late = 0;   // ticks that used the angles of the tick before
    std::uint64_t wrong = 0;  // what came that was no answer
    std::uint64_t jumps = 0;  // to angles that no hand could reach
    std::uint64_t set_ups = 0;
};

/// Threads: as ForceDevice. Only open(), end_in_zero(), stop() and the destructor wait.
class MotorPantograph final : public JointDevice {
  public:
    /// Their watchdogs have let go long before.
    static constexpr int longest_end_ms = 50;

    /// `drives` must have passed check(). The torque limit is the profile's.
    MotorPantograph(std::unique_ptr<MotorPair> pair, const DeviceProfile& profile,
                    const JointDrives& drives);
    /// Calls stop().
    ~MotorPantograph() override;

    /// Arms both controllers and waits for their first angles. The encoders say where the handle
    /// is, unless is_position_doubtful. Takes some tens of ms, or up to 3 s before it fails, in one
    /// line.
    [[nodiscard]] Result<void> open();

    /// Returns the newest angles. Returns nothing while setting up, jumped, refused or lost, and at
    /// most 4 ms after the tick in which the answer came.
    [[nodiscard]] std::optional<JointAngles> read_angles(double now_s) override;

    [[nodiscard]] Freshness freshness() const override { return freshness_; }

    /// Scales torques to the limit. For zero, returns true once both controllers confirmed that
    /// they hold it, so two ticks after the first at the earliest. For other torques, returns false
    /// if they could not be passed on. A torque that is not finite counts as zero and is reported.
    [[nodiscard]] bool write_torques(JointTorques torques) override;

    /// Writes zeros until both controllers are known to hold zero torque: they confirmed a zero,
    /// and nothing else was sent since, which may have been so before. If that is not to be had,
    /// lets the motors go until both have confirmed that. Takes a millisecond or more, or 70 before
    /// it gives up; then their watchdogs have let go. For callers that have no next tick.
    bool end_in_zero();

    /// Lets the motors go and gives the device back. Returns true if both controllers confirmed,
    /// after they were told to, that their motors are let go. Also works for controllers that
    /// another program drove. Takes some milliseconds, or `longest_ms` before it gives up. Nothing
    /// is read or written afterwards.
    bool stop(int longest_ms = longest_end_ms);

    /// After `jumped`, or in doubt: takes the angles as they are. Call it only with the force off.
    void accept_position();

    [[nodiscard]] const DriveReport& report() const { return report_; }

    /// Says the report's trouble in one line; empty if there is none. Not for the tick.
    [[nodiscard]] std::string words() const;

    [[nodiscard]] const DriveFrame& frame() const { return frame_; }

  private:
    void begin_set_up();
    void begin_arming();
    void follow(const PairNews& news);
    void take(ShaftTurns turns, double late_s);
    void judge_position(JointAngles angles, double late_s);
    void judge_age();
    void tick_at_rest();
    bool wait_for(bool PairNews::*confirmed, int longest_ms);

    std::unique_ptr<MotorPair> pair_;
    DriveFrame frame_;
    DriveReport report_;
    std::optional<ShaftTurns> whole_;    // turns left out; nothing: not known since the set-up
    std::optional<JointAngles> angles_;  // last accepted
    std::optional<double> last_s_;       // on the caller's clock
    Freshness freshness_;                // of these
    double angles_age_s_ = 0.0;
    double answer_age_s_ = 0.0;  // of the newest turns, accepted or not
    double set_up_age_s_ = 0.0;
    int attempts_ = 0;  // set-ups in a row that did not end
    int jumps_in_a_row_ = 0;
    double jump_age_s_ = 0.0;  // angles_age_s_ at the first of them
    bool has_jumped_ = false;  // until accept_position() or open()
    bool is_held_zero_ = false;
};

}  // namespace touchline
