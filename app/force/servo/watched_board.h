// The servo's pantograph board. A person homes it when it is opened; then it is watched for whether
// the handle is where its angles say, which is unknown once the machine has slept. Threads: as
// PantographBoard; has_lost_place() from any.
#pragma once

#include "app/force/servo/servo_program.h"
#include "config/types/steady_clock.h"
#include "haptics/device/board/pantograph_board.h"
#include "haptics/device/homing.h"
#include "haptics/servo/real_time.h"

#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

namespace touchline {

class WatchedBoard final : public JointDevice {
  public:
    /// `slept`: how long the machine has slept since some fixed moment, ns.
    WatchedBoard(std::unique_ptr<BoardLink> link, const DeviceProfile& profile,
                 const Calibration& calibration, std::int64_t (*slept)() = slept_ns)
        : JointDevice(profile.geometry),
          board_(std::move(link), profile, calibration),
          drift_(homing_plan(profile, calibration.stop_off)),
          slept_(slept),
          awake_since_ns_(slept()) {}

    /// Homes the handle and tries the motors with the person at the handle; waits on `clock`, a day
    /// at most. `opening` keeps what was found, which lasts as long as the board is set up. Does
    /// neither if `is_homed_first` is false: the handle is at home, for tests. Fails as
    /// PantographBoard::open() and make_ready().
    [[nodiscard]] Result<void> open(bool is_homed_first, const Opening& opening, Clock& clock);

    /// Goes on where a servo that died left the board, without homing. False if the board may not
    /// have counted all the time, the machine slept, or two seconds have passed: open() must come
    /// then.
    [[nodiscard]] bool take_over(const Handover& from);

    /// Where the handle is, for a servo that follows this one.
    [[nodiscard]] HandlePlace place() const {
        return {board_.frame().calibration().offset, awake_since_ns_};
    }

    /// The profile with the unit's own calibration.
    [[nodiscard]] const DeviceProfile& profile() const {
        return board_.frame().calibrated_profile();
    }

    [[nodiscard]] const std::atomic<bool>& has_lost_place() const { return has_lost_place_; }

    [[nodiscard]] std::optional<JointAngles> read_angles(double now_s) override;

    [[nodiscard]] Freshness freshness() const override { return board_.freshness(); }

    [[nodiscard]] std::optional<double> handle_angle_rad() const override {
        return has_lost_place_ ? std::nullopt : board_.handle_angle_rad();
    }

    void turn_handle(double torque_Nm) override { board_.turn_handle(torque_Nm); }

    [[nodiscard]] bool write_torques(JointTorques torques) override {
        return board_.write_torques(torques);
    }

    /// As PantographBoard::end_in_zero(), for the crash handler.
    bool end_in_zero() { return board_.end_in_zero(); }

    /// True if the board confirmed zero torque.
    [[nodiscard]] bool release() { return board_.stop(); }

  private:
    PantographBoard board_;
    DriftWatch drift_;
    std::int64_t (*slept_)();
    std::int64_t awake_since_ns_;                              // the value of slept_ at that moment
    double last_s_ = std::numeric_limits<double>::infinity();  // the loop's last time
    std::atomic<bool> has_lost_place_{false};
};

}  // namespace touchline
