// Tests the program with a device of each make that is not on the USB: emulated controllers of
// motors behind a line, and the emulated service of an Inverse3. The device is named by the
// settings alone, as on a site.
#include "app/force/backends/motors.h"
#include "tests/app/main/kiosk_program.h"
#include "tests/machines/sim/drives/drive_rig.h"
#include "tests/machines/sim/drives/real_time_hosts.h"
#include "tests/machines/sim/drives/shared_peer.h"
#include "tests/machines/sim/inverse3/service_server.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

namespace touchline {
namespace {

class KioskDevice : public KioskProgram {
  protected:
    void choose(const std::string& make, const std::string& port) {
        std::ofstream(folder_ / "kiosk.toml", std::ios::app)
            << "[device]\nmake = '" << make << "'\nport = '" << port << "'\n";
    }
};

/// The loop tells its timing once it has the device.
TEST_F(KioskDevice, AnInverse3BehindItsServiceIsReady) {
    ServiceServer server(
        {}, std::make_shared<WaypointPath>(std::vector<WaypointPath::Waypoint>{{0.0, {}}}));
    choose("inverse3", "04EA@" + std::to_string(server.port()));
    EXPECT_EQ(run_script("kiosk; wait_for timing err.txt; keys b; quit"), 0);
    EXPECT_EQ(complaints().find("Inverse3"), std::string::npos) << complaints();
}

TEST_F(KioskDevice, AnInverse3WhoseServiceIsNotThereIsOneLineThatSaysWhatToDo) {
    choose("inverse3", "@1");
    EXPECT_EQ(run_script("kiosk; wait_for haply err.txt; keys b; quit"), 0);
    EXPECT_NE(complaints().find("nobody answers at port 1 of this computer: start the Inverse3's "
                                "service"),
              std::string::npos)
        << complaints();
}

DriveTruth nobody_there() {
    DriveTruth truth;
    truth.hand = no_hand;
    return truth;
}

/// Nobody holds the handle, which lies in the middle: only a trial moves it.
template <class Machine>
class KioskMotors : public KioskDevice {
  protected:
    void SetUp() override {
        KioskDevice::SetUp();
        setenv("TOUCHLINE_MOTORS", (folder_ / "motors.toml").c_str(), 1);
        MotorUnit unit{Machine::name, {}};
        unit.motors[1].id = 2;
        ASSERT_TRUE(keep_motors(unit).has_value());
        choose(Machine::name, host_.path());
    }

    void TearDown() override {
        unsetenv("TOUCHLINE_MOTORS");
        KioskDevice::TearDown();
    }

    /// Runs a script in which the library stands before the kiosk, and `tried` waits until the
    /// motors have twitched after the time before.
    int run_with_device(const std::string& script) {
        std::atomic<bool> is_over{false};
        std::thread watch([&] {
            for (; !is_over; std::this_thread::sleep_for(std::chrono::milliseconds(5))) note();
        });
        const int status = run_script("export LD_PRELOAD=" TOUCHLINE_SOCKET_TERMINAL
                                      "\ntried() { rm -f twitched; wait_for . twitched; }\n" +
                                      script);
        is_over = true;
        watch.join();
        return status;
    }

    Machine machine_{nobody_there(), Machine::units(), hand_in_the_middle()};
    SharedPeer peer_{machine_.peer()};
    SocketHost host_{peer_};

  private:
    void note() {
        const bool has_twitched = peer_.with([&](double) {
            const auto& changes = machine_.plant().changes();
            const bool has = std::any_of(
                changes.begin() + static_cast<std::ptrdiff_t>(noted_), changes.end(),
                [](const BridgeChange& change) { return change.torques != ShaftTorques{}; });
            noted_ = changes.size();
            return has;
        });
        if (has_twitched) std::ofstream(folder_ / "twitched") << "yes\n";
    }

    std::size_t noted_ = 0;  ///< Changes of the plant that are noted already.
};

using KioskMachines = testing::Types<MoteusMachine, OdriveMachine>;
TYPED_TEST_SUITE(KioskMotors, KioskMachines);

/// The first trial comes by itself, the second when the operator asks for the starting point.
TYPED_TEST(KioskMotors, AreTriedBeforeTheLoopAndAgainWhenTheOperatorAsks) {
    EXPECT_EQ(this->run_with_device(
                  "kiosk; tried; wait_for timing err.txt; keys b h Up Up Down Down Return;"
                  "for i in 1 2; do keys Up Return Up Return Up Return Up Return Return; done;"
                  "keys o; tried; kill -TERM $pid; finish"),
              0)
        << this->complaints();
    const auto changes =
        this->peer_.with([this](double) { return this->machine_.plant().changes(); });
    for (const BridgeChange& change : changes)
        EXPECT_TRUE(change.torques.x == 0.0 || change.torques.y == 0.0) << "a trial, and no force";
    EXPECT_EQ(changes.back().torques, ShaftTorques{});
}

}  // namespace
}  // namespace touchline
