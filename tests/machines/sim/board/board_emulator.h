// A pantograph's board as the USB shows it, with motors, mechanics and a hand behind it; the caller
// passes time in. One library serves every way to reach it: in-process (emulated_link.h), through
// libusb (tests/machines/sim/umockdev) or into a virtual machine. Threads: one at a time.
#pragma once

#include "config/types/calibration.h"
#include "config/types/vec2.h"
#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/pantograph/profile.h"
#include "tests/machines/sim/board/firmware.h"

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace touchline {

/// The true state, whatever the host believes.
struct BoardTruth {
    DeviceProfile profile = default_profile();
    BoardType type = BoardType::m0;
    FirmwareVariant firmware;
    HandModel hand = normal_hand;
    Plugs motors, encoders;  // the real plugs; the profile's wiring may differ
    bool have_motors_power = true;
    JointAngles scale_error;           // relative error of an encoder's counts
    bool do_counts_step_back = false;  // counts 1, 2, 3, 2 a cycle, as one published decoder does
    std::string serial = "0123456789ABCDEF0123456789ABCDEF";
    std::uint64_t seed = 1;
};

/// A packet and when it left the board.
struct SentPacket {
    double at_s = 0.0;
    PacketBytes bytes;
};

/// The motors' torque by joint, from a moment on.
struct TorqueChange {
    double at_s = 0.0;
    JointTorques torques;
    double handle_Nm = 0.0;  // for a handle that turns
};

class BoardEmulator {
  public:
    BoardEmulator(const BoardTruth& truth, std::shared_ptr<const IntendedPath> path);

    /// Runs the board up to t_s; never goes back.
    void advance_to(double t_s);

    [[nodiscard]] double now_s() const { return plant_.time_s(); }

    // The USB side. A board that is absent or in its boot loader neither takes nor gives anything.

    void host_sends(std::span<const std::uint8_t> bytes);
    /// Tells whether the host has an IN transfer waiting.
    void host_listens(bool is_listening);
    [[nodiscard]] std::optional<SentPacket> take_packet();

    void set_line_coding(std::uint32_t baud) { baud_ = baud; }

    void set_lines(bool dtr, bool rts);

    void unplug();
    /// Powers the board again: nothing is set up, and its device number is new.
    void plug();

    [[nodiscard]] bool is_plugged() const { return is_plugged_; }

    /// True after 1200 baud with DTR low killed the firmware: the board now shows a boot loader.
    [[nodiscard]] bool is_boot_loader() const { return is_boot_loader_; }

    [[nodiscard]] int device_number() const { return device_number_; }

    [[nodiscard]] std::uint16_t product() const;

    [[nodiscard]] const BoardTruth& truth() const { return truth_; }

    // What a person does to the board.

    void switch_motors(bool have_power);

    void plug_motors(const Plugs& motors) { truth_.motors = motors; }

    /// Makes an encoder miss counts.
    void lose_counts(int joint, std::int64_t counts);

    /// Another hand takes the handle where it is; with no_hand, nobody holds it.
    void grip(const HandModel& hand) { plant_.grip(hand); }

    // What only a test can see.

    [[nodiscard]] const Firmware& firmware() const { return firmware_; }

    [[nodiscard]] const PantographPlant& plant() const { return plant_; }

    [[nodiscard]] JointAngles true_angles() const { return plant_.angles().value_or(angles_); }

    /// Returns every change of the torque that powered motors would make.
    [[nodiscard]] const std::vector<TorqueChange>& told_torques() const { return changes_; }

    /// Forgets all changes but the last, for runs of hours.
    void forget_told_torques() {
        if (changes_.size() > 1) changes_.erase(changes_.begin(), changes_.end() - 1);
    }

  private:
    [[nodiscard]] PortCounts port_counts();
    [[nodiscard]] JointAngles true_quantum() const;
    [[nodiscard]] bool is_joint_1_on(std::size_t port, const Plugs& plugs) const;
    [[nodiscard]] Turn turn_of(bool is_joint_1, const Plugs& plugs) const;
    [[nodiscard]] double told_handle_torque_Nm() const;
    void update_torques();
    void leave(PacketBytes packet);

    BoardTruth truth_;
    Firmware firmware_;
    PantographPlant plant_;
    JointAngles angles_;
    std::array<std::int64_t, 2> lost_counts_{};  // by joint
    std::vector<TorqueChange> changes_;
    std::uint32_t baud_ = 115200;
    bool are_lines_up_ = false;
    bool is_plugged_ = true;
    bool is_boot_loader_ = false;
    int device_number_ = 2;
    int power_ups_ = 0;
    bool is_host_listening_ = false;
    std::deque<SentPacket> on_the_way_;       // a listening host has taken them
    std::optional<PacketBytes> in_endpoint_;  // the host has not asked for it yet
    bool is_dropping_ = false;                // it has already waited for the host once
};

}  // namespace touchline
