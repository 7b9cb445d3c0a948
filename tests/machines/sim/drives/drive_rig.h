// A driver, its line and an emulated pair of controllers with a pantograph, on one virtual clock.
// Machine is what is at the other end: see MoteusMachine.
#pragma once

#include "haptics/device/drives/motor_pantograph.h"
#include "haptics/device/moteus/fdcanusb_link.h"
#include "haptics/device/moteus/moteus_pair.h"
#include "haptics/device/odrive/odrive_pair.h"
#include "tests/machines/sim/drives/serial_peer.h"
#include "tests/machines/sim/moteus/moteus_bus.h"
#include "tests/machines/sim/odrive/odrive_board.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

inline constexpr double drive_tick_s = 1e-3;

/// A hand that stays in the middle of the drawing area.
inline std::shared_ptr<const IntendedPath> hand_in_the_middle() {
    return std::make_shared<WaypointPath>(std::vector<WaypointPath::Waypoint>{{0.0, {}}});
}

/// Two moteus controllers behind a fdcanusb.
class MoteusMachine {
  public:
    using Truth = MoteusTruth;

    static constexpr const char* name = "moteus";

    static std::array<Truth, 2> units() {
        std::array<Truth, 2> all;
        all[1].id = 2;
        return all;
    }

    MoteusMachine(const DriveTruth& truth, const std::array<Truth, 2>& units,
                  std::shared_ptr<const IntendedPath> path)
        : bus(truth, units, std::move(path)), adapter(bus) {}

    static std::unique_ptr<MotorPair> pair_over(std::unique_ptr<ByteLink> port) {
        return std::make_unique<MoteusPair>(std::make_unique<FdcanusbLink>(std::move(port)),
                                            MoteusIds{1, 2});
    }

    SerialPeer& peer() { return adapter; }

    DrivePlant& plant() { return bus.plant(); }

    [[nodiscard]] const DrivePlant& plant() const { return bus.plant(); }

    void switch_power(bool has_power) { bus.switch_power(has_power); }

    /// Something in the controller of motor 0 or 1 breaks.
    void fail(std::size_t motor) { bus.unit(motor).fail(35); }

    static std::string fault_words() { return "35"; }

    MoteusBus bus;
    FdcanusbEmulator adapter;
};

/// An ODrive with two axes.
class OdriveMachine {
  public:
    using Truth = OdriveTruth;

    static constexpr const char* name = "odrive";

    static std::array<Truth, 2> units() { return {}; }

    OdriveMachine(const DriveTruth& truth, const std::array<Truth, 2>& axes,
                  std::shared_ptr<const IntendedPath> path)
        : board(truth, axes, std::move(path)) {}

    static std::unique_ptr<MotorPair> pair_over(std::unique_ptr<ByteLink> port) {
        return std::make_unique<OdrivePair>(std::move(port), 0.25);
    }

    SerialPeer& peer() { return board; }

    DrivePlant& plant() { return board.plant(); }

    [[nodiscard]] const DrivePlant& plant() const { return board.plant(); }

    void switch_power(bool has_power) { board.switch_power(has_power); }

    /// Something in the axis of motor 0 or 1 breaks.
    void fail(std::size_t motor) { board.fail(motor, 1U << 8U); }

    static std::string fault_words() { return "encoder gave up"; }

    OdriveBoard board;
};

template <class Machine>
class DriveRig {
  public:
    using Units = std::array<typename Machine::Truth, 2>;

    explicit DriveRig(const DriveTruth& truth = {}, const Units& units = Machine::units(),
                      std::shared_ptr<const IntendedPath> path = hand_in_the_middle())
        : machine(truth, units, std::move(path)) {
        connect(truth.drives);
    }

    /// Makes a new driver, as another program would; the one before gives the device back.
    void connect(const JointDrives& drives) {
        driver.reset();
        auto made = std::make_unique<EmulatedSerial>(machine.peer(), time);
        line = made.get();
        driver = std::make_unique<MotorPantograph>(Machine::pair_over(std::move(made)),
                                                   plant().truth().profile, drives);
    }

    /// Does one servo tick: passes time, reads, writes. Writes zero instead of `torques` if there
    /// are no angles.
    std::optional<JointAngles> tick(JointTorques torques) {
        pass(drive_tick_s);
        const auto angles = driver->read_angles(time.now_s);
        is_written = driver->write_torques(angles ? torques : JointTorques{});
        return angles;
    }

    void tick_for(double span_s, JointTorques torques) {
        for (double left_s = span_s; left_s > 0.5 * drive_tick_s; left_s -= drive_tick_s)
            (void)tick(torques);
    }

    /// Lets time pass while the host does nothing.
    void pass(double span_s) {
        time.now_s += span_s;
        machine.peer().advance_to(time.now_s);
    }

    /// What the motors do at the joints now.
    [[nodiscard]] JointTorques held() {
        machine.peer().advance_to(time.now_s);
        return DriveFrame(plant().truth().profile, plant().truth().drives)
            .joint_torques(plant().changes().back().torques);
    }

    [[nodiscard]] std::array<Bridge, 2> bridges() {
        machine.peer().advance_to(time.now_s);
        return plant().changes().back().bridges;
    }

    /// When the torque was first zero at or after a moment; for ever if it never was.
    [[nodiscard]] double zero_from(double from_s) {
        machine.peer().advance_to(time.now_s);
        double zero_s = never;
        for (const BridgeChange& change : plant().changes()) {
            const bool is_zero = change.torques == ShaftTorques{};
            if (!is_zero)
                zero_s = never;
            else if (zero_s == never)
                zero_s = change.at_s;
        }
        return zero_s == never ? never : std::max(zero_s, from_s);
    }

    [[nodiscard]] DrivePlant& plant() { return machine.plant(); }

    [[nodiscard]] const DrivePlant& plant() const { return machine.plant(); }

    static constexpr double never = 1e9;

    VirtualTime time;
    Machine machine;
    EmulatedSerial* line = nullptr;
    std::unique_ptr<MotorPantograph> driver;
    bool is_written = false;
};

}  // namespace touchline
