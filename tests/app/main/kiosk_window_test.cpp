// Tests what the window adds to a kiosk: the hand that a pointer leads, and signs of life.
#include "app/main/kiosk_window.h"

#include "app/main/life_signs.h"
#include "config/types/pinned.h"
#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/servo/servo_step.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr std::int64_t second_ns = 1'000'000'000;

TEST(WatchdogPace, FeedsFourTimesInItsTimeWhileBothHeartsBeat) {
    WatchdogPace pace(10 * second_ns);
    int fed = 0;
    for (int frame = 0; frame < 60 * 100; ++frame) {
        const std::int64_t now_ns = frame * second_ns / 60;
        fed += pace.step(now_ns, static_cast<std::uint64_t>(frame)) ? 1 : 0;
    }
    EXPECT_EQ(fed, 40);
}

TEST(WatchdogPace, StarvesTheWatchdogWhenTheServosHeartStops) {
    WatchdogPace pace(10 * second_ns);
    EXPECT_TRUE(pace.step(0, 7));
    for (int frame = 1; frame < 6000; ++frame) EXPECT_FALSE(pace.step(frame * second_ns / 60, 7));
    EXPECT_TRUE(pace.step(200 * second_ns, 8));
}

TEST(WatchdogPace, OneThatBeatsOnceInAQuarterIsAlive) {
    WatchdogPace pace(10 * second_ns);
    std::int64_t fed_ns = 0;
    for (std::int64_t now_ns = 0; now_ns < 100 * second_ns; now_ns += second_ns / 60) {
        const auto beats = static_cast<std::uint64_t>(now_ns / (5 * second_ns / 2));
        if (pace.step(now_ns, beats)) fed_ns = now_ns;
        EXPECT_LT(now_ns - fed_ns, 10 * second_ns);
    }
}

TEST(WatchdogPace, WithoutAWatchdogNothingIsFed) {
    WatchdogPace pace(0);
    for (int frame = 0; frame < 100; ++frame) EXPECT_FALSE(pace.step(frame * second_ns, 1U));
}

/// The process that started the kiosk, with a socket for it to talk to.
class Starter : private Pinned {
  public:
    Starter() {
        sockaddr_un place{};
        place.sun_family = AF_UNIX;
        const std::string path = path_.string();
        path.copy(place.sun_path, sizeof place.sun_path - 1);
        EXPECT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof place), 0);
        setenv("NOTIFY_SOCKET", path.c_str(), 1);
        setenv("WATCHDOG_USEC", "10000000", 1);
    }

    ~Starter() {
        unsetenv("NOTIFY_SOCKET");
        unsetenv("WATCHDOG_USEC");
        close(socket_);
        std::filesystem::remove(path_);
    }

    [[nodiscard]] std::vector<std::string> heard() const {
        std::vector<std::string> signs;
        std::array<char, 64> text{};
        for (;;) {
            const ssize_t size = recv(socket_, text.data(), text.size(), MSG_DONTWAIT);
            if (size < 0) return signs;
            signs.emplace_back(text.data(), static_cast<std::size_t>(size));
        }
    }

  private:
    std::filesystem::path path_ =
        std::filesystem::temp_directory_path() / ("touchline-signs-" + std::to_string(getpid()));
    int socket_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
};

TEST(LifeSigns, ReadyOnceThenAliveThenEnding) {
    const Starter starter;
    LifeSigns signs;
    for (int frame = 0; frame < 60 * 6; ++frame)
        signs.beat(frame * second_ns / 60, static_cast<std::uint64_t>(frame));
    LifeSigns::end();
    EXPECT_EQ(starter.heard(), (std::vector<std::string>{"READY=1", "WATCHDOG=1", "WATCHDOG=1",
                                                         "WATCHDOG=1", "STOPPING=1"}));
}

TEST(LifeSigns, AServoThatStandsStillIsNotHeardOfAgain) {
    const Starter starter;
    LifeSigns signs;
    for (int frame = 0; frame < 60 * 60; ++frame) signs.beat(frame * second_ns / 60, 5);
    EXPECT_EQ(starter.heard(), (std::vector<std::string>{"READY=1", "WATCHDOG=1"}));
}

TEST(LifeSigns, WithoutAListenerItIsSilent) {
    LifeSigns signs;
    signs.beat(0, 1);
    LifeSigns::end();
}

TEST(PointerPace, GetsThereAndNoFaster) {
    EXPECT_EQ(paced({0.01, 0.0}, {0.015, 0.0}, 1.0 / 60), (Position{0.015, 0.0}));
    EXPECT_NEAR(paced({0.0, 0.0}, {0.05, 0.0}, 1.0 / 60).x, 0.01, 1e-12);
}

/// The pointer leaps from corner to corner of the picture, twice a second.
TEST(PointerPace, APointerThatLeapsLeavesTheForceOn) {
    const auto hand = std::make_shared<MouseHand>(Position{});
    SimulatedPantograph device(default_profile(), {}, hand);
    ServoStep step(default_profile(), 1e-3);
    Position led;
    for (int k = 0; k < 20'000; ++k) {
        const Position pointer = k / 500 % 2 == 0 ? Position{0.055, 0.04} : Position{-0.055, -0.04};
        if (k % 17 == 0) {
            led = paced(led, pointer, 1.0 / 60);
            hand->move_to(led);
        }
        StepInput input;
        input.now_s = 1e-3 * k;
        input.reading = device.read(input.now_s);
        (void)device.write(step.step(input));
        ASSERT_NE(step.report().force.state, ForceState::fault) << k;
    }
    EXPECT_EQ(step.report().force.state, ForceState::live);
}

}  // namespace
}  // namespace touchline
