// Kiosk and servo as real processes, with the emulated service of an Inverse3 behind a socket: the
// servo is killed or frozen while the handle is pulled, and the service never ends a force by
// itself.
#include "app/force/backends/inverse3.h"
#include "tests/app/force/servo/make_kiosk.h"
#include "tests/app/signal_one.h"
#include "tests/machines/sim/inverse3/service_server.h"

#include <algorithm>
#include <csignal>
#include <string>
#include <vector>

namespace touchline {
namespace {

ServiceTruth one_that_holds_its_last_force() {
    ServiceTruth truth;
    truth.idle_after_s = 1e9;
    return truth;
}

bool is_in_the_plane(Space force_N) {
    return force_N.x != 0.0 || force_N.y != 0.0;
}

class Inverse3Process : public testing::Test {
  protected:
    [[nodiscard]] std::string port() const { return "@" + std::to_string(server_.port()); }

    /// Does it on the service's time, as soon as the hand is pulled.
    [[nodiscard]] bool act_while_pulling(const std::function<void()>& act) {
        return kiosk_.looks_until([&] {
            return server_.with([&](ServiceEmulator& service) {
                if (!is_in_the_plane(service.applied_N())) return false;
                act();
                return true;
            });
        });
    }

    void expect_free_and_pulled_again(int signal) {
        ASSERT_TRUE(act_while_pulling([&] { signal_one(kiosk_.servo(), signal); }))
            << kiosk_.told();
        EXPECT_TRUE(kiosk_.looks_until([&] {
            return server_.with(
                [](ServiceEmulator& service) { return service.applied_N() == Space{}; });
        }));
        EXPECT_TRUE(kiosk_.looks_until([&] {
            return kiosk_.told().find("the torque was zeroed") != std::string::npos;
        })) << kiosk_.told();
        EXPECT_TRUE(act_while_pulling([] {})) << kiosk_.told();
    }

    ServiceServer server_{
        one_that_holds_its_last_force(),
        std::make_shared<WaypointPath>(std::vector<WaypointPath::Waypoint>{{0.0, {}}})};
    MakeKiosk kiosk_{"inverse3", port(), [](const std::string&) {}};
};

TEST_F(Inverse3Process, AKilledServosForceEndsAndTheNextServoPullsAgain) {
    expect_free_and_pulled_again(SIGKILL);
}

TEST_F(Inverse3Process, AFrozenServosForceEndsAndTheNextServoPullsAgain) {
    expect_free_and_pulled_again(SIGSTOP);
}

}  // namespace
}  // namespace touchline
