// A driver, its link and an emulated board on one virtual clock.
#pragma once

#include "haptics/device/board/pantograph_board.h"
#include "tests/machines/sim/board/board_emulator.h"
#include "tests/machines/sim/board/emulated_link.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace touchline {

inline constexpr double rig_tick_s = 1e-3;

/// A hand that stays where the tip is at home.
inline std::shared_ptr<const IntendedPath> resting_hand(const DeviceProfile& profile) {
    const Position home = forward(profile.geometry, profile.home).value().p_DH;
    return std::make_shared<WaypointPath>(
        std::vector<WaypointPath::Waypoint>{{0.0, picture_from_device(profile, home)}});
}

class BoardRig {
  public:
    explicit BoardRig(const BoardTruth& truth = {}, std::vector<PlannedFault> faults = {},
                      const Calibration& calibration = {},
                      std::shared_ptr<const IntendedPath> path = nullptr)
        : board(truth, path ? std::move(path) : resting_hand(truth.profile)) {
        connect(std::move(faults), calibration);
    }

    /// Makes a new driver, as another program would; the previous one gives the board back. `kind`:
    /// the kind that the driver assumes, if not the true one.
    void connect(std::vector<PlannedFault> faults = {}, const Calibration& calibration = {},
                 const DeviceProfile* kind = nullptr) {
        driver.reset();
        auto made = std::make_unique<EmulatedLink>(board, time, std::move(faults));
        link = made.get();
        driver = std::make_unique<PantographBoard>(
            std::move(made), kind ? *kind : board.truth().profile, calibration);
    }

    /// Does one servo tick: passes time, reads, writes. Writes zero instead of `torques` if there
    /// are no angles.
    std::optional<JointAngles> tick(JointTorques torques) {
        time.now_s += rig_tick_s;
        const auto angles = driver->read_angles(time.now_s + clock_step_s);
        is_written = driver->write_torques(angles ? torques : JointTorques{});
        return angles;
    }

    void tick_for(double span_s, JointTorques torques) {
        for (double left_s = span_s; left_s > 0.0; left_s -= rig_tick_s) (void)tick(torques);
    }

    /// The torques that the board was last told to hold.
    [[nodiscard]] JointTorques held() {
        board.advance_to(time.now_s);
        const auto& changes = board.told_torques();
        return changes.empty() ? JointTorques{} : changes.back().torques;
    }

    VirtualTime time;
    BoardEmulator board;
    EmulatedLink* link = nullptr;
    std::unique_ptr<PantographBoard> driver;
    bool is_written = false;
    double clock_step_s = 0.0;  // offset of the driver's clock
};

}  // namespace touchline
