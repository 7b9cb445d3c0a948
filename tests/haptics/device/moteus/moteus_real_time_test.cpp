// The whole way in real time: through a serial port of the system, and through a socket that
// carries CAN-FD frames. Times are those of a machine that has other work.
#include "haptics/device/drives/motor_pantograph.h"
#include "haptics/device/moteus/can_socket.h"
#include "haptics/device/serial/serial_port.h"
#include "tests/machines/sim/drives/drive_rig.h"
#include "tests/machines/sim/drives/real_time_hosts.h"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr JointTorques soft_press{0.03, -0.02};

/// Presses for half a second as the servo's loop would. Returns how many ticks had angles.
int press_for_a_while(MotorPantograph& driver) {
    const auto start = std::chrono::steady_clock::now();
    int with_angles = 0;
    for (int k = 0; k < 500; ++k) {
        std::this_thread::sleep_until(start + k * std::chrono::milliseconds(1));
        const std::chrono::duration<double> now = std::chrono::steady_clock::now() - start;
        const auto angles = driver.read_angles(now.count());
        with_angles += angles ? 1 : 0;
        (void)driver.write_torques(angles ? soft_press : JointTorques{});
    }
    return with_angles;
}

// Each machine presses until its host falls silent, and then lets go by itself.
void expect_pressed_and_let_go(DrivePlant& plant) {
    double pressed_s = 0.0, let_go_s = 0.0;
    for (const BridgeChange& change : plant.changes()) {
        if (change.torques != ShaftTorques{})
            pressed_s = change.at_s;
        else if (pressed_s > let_go_s)
            let_go_s = change.at_s;
    }
    EXPECT_GT(pressed_s, 0.0);
    EXPECT_GE(let_go_s, pressed_s);
    EXPECT_EQ(plant.changes().back().torques, ShaftTorques{});
    EXPECT_EQ(plant.changes().back().bridges, (std::array{Bridge::off, Bridge::off}));
}

TEST(MoteusInRealTime, PressesThroughASerialPortAndItsWatchdogLetsGo) {
    MoteusMachine machine({}, MoteusMachine::units(), hand_in_the_middle());
    PtyHost host(machine.adapter);
    auto port = open_serial_port(host.path());
    ASSERT_TRUE(port.has_value()) << port.error().line;
    MotorPantograph driver(MoteusMachine::pair_over(std::move(*port)), DriveTruth{}.profile, {});
    const auto opened = driver.open();
    ASSERT_TRUE(opened.has_value()) << opened.error().line;
    EXPECT_GT(press_for_a_while(driver), 20);
    host.end_after(0.2);
    expect_pressed_and_let_go(machine.plant());
}

TEST(MoteusInRealTime, APlugThatIsPulledIsLost) {
    MoteusMachine machine({}, MoteusMachine::units(), hand_in_the_middle());
    PtyHost host(machine.adapter);
    auto port = open_serial_port(host.path());
    ASSERT_TRUE(port.has_value()) << port.error().line;
    MotorPantograph driver(MoteusMachine::pair_over(std::move(*port)), DriveTruth{}.profile, {});
    ASSERT_TRUE(driver.open().has_value());
    host.unplug();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_FALSE(driver.read_angles(1.0).has_value());
    EXPECT_EQ(driver.report().state, DriveState::lost);
}

TEST(MoteusInRealTime, PressesThroughACanSocketAndItsWatchdogLetsGo) {
    MoteusBus bus({}, MoteusMachine::units(), hand_in_the_middle());
    CanHost host(bus);
    MotorPantograph driver(std::make_unique<MoteusPair>(
                               std::make_unique<CanSocket>(host.take_socket()), MoteusIds{1, 2}),
                           DriveTruth{}.profile, {});
    const auto opened = driver.open();
    ASSERT_TRUE(opened.has_value()) << opened.error().line;
    EXPECT_GT(press_for_a_while(driver), 20);
    host.end_after(0.2);
    expect_pressed_and_let_go(bus.plant());
}

TEST(CanSocket, AnInterfaceThatIsNotThereIsSaidInOneLine) {
    for (const char* name : {"no-such-can", "", "a-name-that-is-too-long"}) {
        const auto link = open_can_socket(name);
        ASSERT_FALSE(link.has_value());
        EXPECT_NE(link.error().line.find("could not be opened"), std::string::npos);
    }
}

}  // namespace
}  // namespace touchline
