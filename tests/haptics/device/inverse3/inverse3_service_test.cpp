// The client of the service's WebSocket, with the emulated service behind a real socket.
#include "haptics/device/inverse3/inverse3_service.h"

#include "config/types/steady_clock.h"
#include "tests/haptics/call_counts.h"
#include "tests/machines/sim/inverse3/service_server.h"

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace touchline {
namespace {

using namespace std::chrono_literals;

std::shared_ptr<const IntendedPath> resting() {
    return std::make_shared<WaypointPath>(
        std::vector<WaypointPath::Waypoint>{{0.0, {0.01, -0.02}}});
}

class Inverse3ServiceTest : public testing::Test {
  protected:
    void connect() {
        auto connected = Inverse3Service::connect("", server.port());
        ASSERT_TRUE(connected) << connected.error().line;
        service = std::move(*connected);
    }

    /// One wish a millisecond.
    void push(Space force_N, double span_s) {
        for (double left_s = span_s; left_s > 5e-4; left_s -= 0.001) {
            service->tell({force_N, ++number});
            service->rest(0.001);
        }
    }

    [[nodiscard]] Space applied() {
        return server.with([](ServiceEmulator& e) { return e.applied_N(); });
    }

    /// Waits for it, because other programs may hold this one up.
    template <class Condition>
    [[nodiscard]] bool comes(Condition condition) {
        for (int i = 0; i < 2000 && !condition(); ++i) std::this_thread::sleep_for(1ms);
        return condition();
    }

    ServiceServer server{lasting(), resting()};
    std::unique_ptr<Inverse3Service> service;
    std::uint64_t number = 0;

  private:
    /// One that goes idle by nothing but words.
    static ServiceTruth lasting() {
        ServiceTruth truth;
        truth.idle_after_s = 1e9;
        return truth;
    }
};

TEST_F(Inverse3ServiceTest, ForcesGoAndPlacesComeBack) {
    connect();
    push({0.25, -0.5, 0.125}, 0.3);
    EXPECT_EQ(applied(), (Space{0.25, -0.5, 0.125}));
    const ArmNews news = service->news();
    EXPECT_GT(news.places, 20U);
    EXPECT_EQ(news.no_news, 0U);
    const Space place = server.with([](ServiceEmulator& e) { return e.place_m(); });
    EXPECT_NEAR(news.place_m.x, place.x, 1e-4);
    EXPECT_NEAR(news.place_m.y, place.y, 1e-4);
}

TEST_F(Inverse3ServiceTest, ZeroIsConfirmedByWhatTheServiceSays) {
    connect();
    push({0.5, 0.0, 0.0}, 0.1);
    service->tell({{}, ++number});
    EXPECT_TRUE(comes([&] {
        const ArmNews news = service->news();
        return news.answered >= number && news.applies_none;
    }));
    EXPECT_EQ(applied(), Space{});
}

TEST_F(Inverse3ServiceTest, AForceThatNobodyRenewsBecomesZero) {
    connect();
    push({1.0, 0.0, 0.0}, 0.1);
    EXPECT_TRUE(comes([&] { return applied() == Space{}; }));
}

TEST_F(Inverse3ServiceTest, AHushedServiceIsToldZero) {
    connect();
    push({1.0, 0.0, 0.0}, 0.1);
    server.hush(true);
    push({1.0, 0.0, 0.0}, 0.05);
    EXPECT_TRUE(comes([&] { return applied() == Space{}; }));
    push({1.0, 0.0, 0.0}, 0.05);
    EXPECT_EQ(applied(), Space{});
    server.hush(false);
    push({1.0, 0.0, 0.0}, 0.1);
    EXPECT_EQ(applied(), (Space{1.0, 0.0, 0.0}));
}

TEST_F(Inverse3ServiceTest, CutTellsZeroWhateverIsWanted) {
    connect();
    push({1.0, 0.0, 0.0}, 0.1);
    EXPECT_TRUE(service->cut() || comes([&] { return service->cut(); }));
    push({1.0, 0.0, 0.0}, 0.05);
    EXPECT_EQ(applied(), Space{});
}

TEST_F(Inverse3ServiceTest, TheEndTellsZero) {
    connect();
    push({1.0, 0.0, 0.0}, 0.1);
    service.reset();
    EXPECT_TRUE(comes([&] { return applied() == Space{}; }));
}

TEST_F(Inverse3ServiceTest, AServiceThatClosesIsGoneForGood) {
    connect();
    push({1.0, 0.0, 0.0}, 0.05);
    server.drop();
    EXPECT_TRUE(comes([&] { return service->news().is_gone; }));
    service->tell({{1.0, 0.0, 0.0}, ++number});
    EXPECT_FALSE(service->cut());
    connect();  // another conversation
    push({1.0, 0.0, 0.0}, 0.05);
    EXPECT_FALSE(service->news().is_gone);
}

TEST_F(Inverse3ServiceTest, AFrameThatIsTooLongEndsTheConversation) {
    connect();
    server.say(std::string(longest_frame_bytes + 1, ' '));
    EXPECT_TRUE(comes([&] { return service->news().is_gone; }));
}

TEST_F(Inverse3ServiceTest, WhatNobodyAskedForIsCounted) {
    connect();
    server.say("no frame");
    EXPECT_TRUE(comes([&] { return service->news().no_news == 1; }));
}

TEST_F(Inverse3ServiceTest, TheTicksCallsNeitherAllocateNorLock) {
    connect();
    CallCounts counts;
    {
        const CallCounter counter;
        for (int i = 0; i < 1000; ++i) {
            service->tell({{0.1, 0.0, 0.0}, ++number});
            (void)service->news();
        }
        counts = take_call_counts();
    }
    EXPECT_EQ(counts.allocations, 0U);
    EXPECT_EQ(counts.locks, 0U);
}

TEST(Inverse3ServiceDoor, WithoutAServiceOneLineSaysWhatToDo) {
    std::uint16_t port = 0;
    {
        const ServiceServer gone({}, resting());
        port = gone.port();
    }
    const auto connected = Inverse3Service::connect("", port);
    ASSERT_FALSE(connected);
    EXPECT_NE(connected.error().line.find("start the Inverse3's service"), std::string::npos);
}

TEST(Inverse3ServiceDoor, WithoutADeviceOneLineSaysWhatToDo) {
    ServiceTruth none;
    none.arms.clear();
    const ServiceServer server(none, resting());
    const auto connected = Inverse3Service::connect("", server.port());
    ASSERT_FALSE(connected);
    EXPECT_NE(connected.error().line.find("no Inverse3 is plugged in"), std::string::npos);
}

/// Takes one connection and says nothing, or something that is no WebSocket.
class Stranger : private Pinned {
  public:
    explicit Stranger(std::string words) : words_(std::move(words)) {
        sockaddr_in here{};
        here.sin_family = AF_INET;
        here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof here;
        auto* const address = reinterpret_cast<sockaddr*>(&here);
        EXPECT_EQ(::bind(door_, address, size), 0);
        EXPECT_EQ(::listen(door_, 1), 0);
        EXPECT_EQ(::getsockname(door_, address, &size), 0);
        port = ntohs(here.sin_port);
        thread_ = std::thread([this] {
            const int guest = ::accept(door_, nullptr, nullptr);
            if (guest < 0) return;
            EXPECT_EQ(::write(guest, words_.data(), words_.size()),
                      static_cast<ssize_t>(words_.size()));
            std::array<char, 512> heard{};
            while (::read(guest, heard.data(), heard.size()) > 0) continue;
            ::close(guest);
        });
    }

    ~Stranger() {
        ::shutdown(door_, SHUT_RDWR);
        thread_.join();
        ::close(door_);
    }

    std::uint16_t port = 0;

  private:
    std::string words_;
    int door_ = ::socket(AF_INET, SOCK_STREAM, 0);
    std::thread thread_;
};

TEST(Inverse3ServiceDoor, AnotherProgramAtThePortIsNotTheService) {
    for (const std::string& words : {std::string(), std::string("HTTP/1.1 200 OK\r\n\r\n")}) {
        const Stranger stranger(words);
        const std::int64_t begun_ns = steady_now_ns();
        const auto connected = Inverse3Service::connect("", stranger.port);
        ASSERT_FALSE(connected);
        EXPECT_NE(connected.error().line.find("is not the Inverse3's service"), std::string::npos);
        EXPECT_LT(steady_now_ns() - begun_ns, 10'000'000'000);
    }
}

}  // namespace
}  // namespace touchline
