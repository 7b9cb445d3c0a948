// The Inverse3 as the servo opens it and as its guard tells it zero, with the emulated service
// behind a real socket.
#include "app/force/servo/inverse3_arm.h"

#include "haptics/servo/real_time.h"
#include "tests/machines/sim/inverse3/service_server.h"

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using namespace std::chrono_literals;

std::shared_ptr<const IntendedPath> at_rest() {
    return std::make_shared<WaypointPath>(
        std::vector<WaypointPath::Waypoint>{{0.0, {0.01, -0.02}}});
}

/// The person and the kiosk.
struct Watcher {
    std::vector<std::string> said;
    int asked = 0;
    int most_asked = 1'000'000;

    Opening opening() {
        Opening made;
        made.say = [this](const std::string& words) { said.push_back(words); };
        made.goes_on = [this] { return ++asked < most_asked; };
        return made;
    }
};

/// A tick a millisecond, for the device of a servo. Returns how many told a place.
int drive(OpenedDevice& opened, const DeviceCommand& command, double span_s) {
    MonotonicClock clock;
    TickSchedule schedule(clock.now_ns(), 1'000'000);
    int placed = 0;
    while (schedule.due_s() < span_s) {
        clock.sleep_until(schedule.due_ns());
        const auto told = opened.device->read(schedule.due_s());
        placed += told ? 1 : 0;
        (void)opened.device->write(told ? command : DeviceCommand{});
        schedule.finish(clock.now_ns());
    }
    return placed;
}

Space applied(ServiceServer& server) {
    return server.with([](ServiceEmulator& e) { return e.applied_N(); });
}

constexpr DeviceCommand push{{0.5, 0.0}, {}, 0.0, 1.0};

TEST(Inverse3Arm, ItsAddressIsANameAPortOrBoth) {
    const auto read = [](const std::string& text) {
        const auto address = arm_address_of(text);
        return address ? address->name + ' ' + std::to_string(address->port) : "";
    };
    EXPECT_EQ(read(""), " 10001");
    EXPECT_EQ(read("04EA"), "04EA 10001");
    EXPECT_EQ(read("04EA@10002"), "04EA 10002");
    EXPECT_EQ(read("@1"), " 1");
    EXPECT_EQ(read("@65535"), " 65535");
    for (const char* const wrong :
         {"@", "04EA@", "@0", "@65536", "@-1", "@1x", "@1@2", "04 EA", "/dev/ttyACM0"})
        EXPECT_EQ(read(wrong), "") << wrong;
}

TEST(Inverse3Arm, IsOpenedDrivenAndReleasedWithZeroConfirmed) {
    ServiceServer server({}, at_rest());
    Watcher watcher;
    auto opened = open_inverse3({"", server.port()}, watcher.opening());
    ASSERT_TRUE(opened) << opened.error().line;
    EXPECT_TRUE(watcher.said.empty());
    EXPECT_FALSE(has_joints(opened->profile));
    EXPECT_GT(drive(*opened, push, 0.5), 10);
    EXPECT_TRUE(opened->release());
    EXPECT_EQ(applied(server), Space{});
}

TEST(Inverse3Arm, OneThatIsNotFitIsWaitedForWithWords) {
    ServiceTruth truth;
    truth.arms[0].is_calibrated = false;
    ServiceServer server(truth, at_rest());
    Watcher watcher;
    std::thread person([&] {
        std::this_thread::sleep_for(700ms);
        server.with([](ServiceEmulator& e) { return e.arm().is_calibrated = true; });
    });
    const auto opened = open_inverse3({"", server.port()}, watcher.opening());
    person.join();
    ASSERT_TRUE(opened) << opened.error().line;
    ASSERT_EQ(watcher.said.size(), 2U);
    EXPECT_EQ(watcher.said[0], words_of(Hindrance::not_calibrated));
    EXPECT_EQ(watcher.said[1], "") << "nothing to do any more";
}

TEST(Inverse3Arm, NobodyWhoWantsItAnyMoreEndsTheWait) {
    ServiceTruth truth;
    truth.arms[0].has_power = false;
    ServiceServer server(truth, at_rest());
    Watcher watcher;
    watcher.most_asked = 100;
    EXPECT_FALSE(open_inverse3({"", server.port()}, watcher.opening()));
}

TEST(Inverse3Arm, TheCrashHandlersZeroReachesTheService) {
    ServiceTruth truth;
    truth.idle_after_s = 1e9;
    ServiceServer server(truth, at_rest());
    Watcher watcher;
    auto opened = open_inverse3({"", server.port()}, watcher.opening());
    ASSERT_TRUE(opened) << opened.error().line;
    (void)drive(*opened, push, 0.5);
    opened->zero.write(opened->zero.device);
    for (int i = 0; i < 1000 && applied(server) != Space{}; ++i) std::this_thread::sleep_for(1ms);
    EXPECT_EQ(applied(server), Space{});
}

TEST(Inverse3Arm, TheGuardTellsZeroInAConversationOfItsOwn) {
    ServiceServer server({}, at_rest());
    const auto zeroed = zero_inverse3({"", server.port()});
    EXPECT_TRUE(zeroed) << zeroed.error().line;
    ServiceTruth none;
    none.arms.clear();
    ServiceServer empty(none, at_rest());
    EXPECT_FALSE(zero_inverse3({"", empty.port()}));
}

TEST(Inverse3Arm, AServiceThatGoesOnWithAForceIsToldApart) {
    ServiceTruth truth;
    truth.clings = true;
    ServiceServer server(truth, at_rest());
    Watcher watcher;
    {
        auto opened = open_inverse3({"", server.port()}, watcher.opening());
        ASSERT_TRUE(opened) << opened.error().line;
        for (int i = 0; i < 20 && applied(server) == Space{}; ++i) (void)drive(*opened, push, 0.1);
        ASSERT_NE(applied(server), Space{});
        EXPECT_FALSE(opened->release());
    }
    EXPECT_FALSE(zero_inverse3({"", server.port()}));
}

}  // namespace
}  // namespace touchline
