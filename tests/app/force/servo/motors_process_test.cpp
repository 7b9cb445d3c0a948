// Kiosk and servo as real processes, with a pantograph whose motors have controllers: one or both
// are killed or frozen while the handle is pulled. Judged on the emulated controllers' clock, which
// stands still while they do, so that a busy machine changes nothing.
#include "app/force/backends/motors.h"
#include "tests/app/force/servo/make_kiosk.h"
#include "tests/app/signal_one.h"
#include "tests/machines/sim/drives/drive_rig.h"
#include "tests/machines/sim/drives/real_time_hosts.h"
#include "tests/machines/sim/drives/shared_peer.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <string>

namespace touchline {
namespace {

constexpr double longest_free_s =
    watchdog_s + SharedPeer::longest_turn_s + 2.5e-4;  // two of the emulator's steps
constexpr double most_nudge_Nm = 0.03;

DriveTruth nobody_holds_it() {
    DriveTruth truth;
    truth.hand = no_hand;
    return truth;
}

bool is_at_rest(const BridgeChange& change) {
    return change.torques == ShaftTorques{};
}

template <class Machine>
class MotorsProcess : public testing::Test {
  protected:
    void SetUp() override {
        file_ = testing::TempDir() + "motors-" + std::to_string(getpid());
        setenv("TOUCHLINE_MOTORS", file_.c_str(), 1);
        MotorUnit unit{Machine::name, {}};
        unit.motors[1].id = 2;
        ASSERT_TRUE(keep_motors(unit).has_value());
        kiosk_.emplace(Machine::name, host_.path(), [this](const auto& words) { follow(words); });
    }

    void TearDown() override {
        kiosk_.reset();
        unsetenv("TOUCHLINE_MOTORS");
        std::filesystem::remove(file_);
    }

    /// The person lets go of the handle while that is asked for, and holds it else.
    void follow(const std::string& words) {
        const bool lets_go = words.find("et go of it") != std::string::npos;
        if (std::exchange(lets_go_, lets_go) != lets_go)
            peer_.with([&](double) { machine_.plant().grip(lets_go ? no_hand : normal_hand); });
        tries_ += lets_go && !was_asked_ ? 1 : 0;
        was_asked_ = lets_go;
    }

    [[nodiscard]] bool is_tried() const { return tries_ > 0 && !was_asked_; }

    /// Ends the processes while the motors have torque. Returns when, on the controllers' clock.
    [[nodiscard]] std::optional<double> end_while_pulling(const std::function<void()>& act) {
        std::optional<double> at_s;
        EXPECT_TRUE(kiosk_->looks_until([&] {
            if (!is_tried()) return false;
            return peer_.with([&](double now_s) {
                if (is_at_rest(machine_.plant().changes().back())) return false;
                act();
                at_s = now_s;
                return true;
            });
        })) << kiosk_->told();
        return at_s;
    }

    /// Waits until the controllers have lived on for so long.
    void pass(double until_s) {
        EXPECT_TRUE(kiosk_->looks_until([&] { return now_s() > until_s; }));
    }

    /// What the motors did from then on, without what they did before.
    [[nodiscard]] std::vector<BridgeChange> changes_since(double from_s) {
        return peer_.with([&](double) {
            std::vector<BridgeChange> since;
            std::ranges::copy_if(machine_.plant().changes(), std::back_inserter(since),
                                 [&](const BridgeChange& each) { return each.at_s >= from_s; });
            return since;
        });
    }

    /// Expects that the motors were let go in time, and stayed so until now.
    void expect_free_after(double from_s) {
        const auto changes = changes_since(from_s);
        const auto freed = std::ranges::find_if(changes, is_at_rest);
        ASSERT_NE(freed, changes.end());
        EXPECT_LE(freed->at_s - from_s, longest_free_s);
        EXPECT_TRUE(std::all_of(freed, changes.end(), is_at_rest));
    }

    void expect_free_for_good(double from_s) {
        pass(from_s + 1.0);
        expect_free_after(from_s);
        EXPECT_EQ(changes_since(from_s).back().bridges, (std::array{Bridge::off, Bridge::off}));
    }

    /// Nobody is left who could tell the controllers anything: the guard is frozen before its servo
    /// gets the signal.
    void expect_free_without_a_guard(int signal) {
        const auto from_s = end_while_pulling([&] {
            signal_one(kiosk_->pid(), SIGSTOP);
            signal_one(kiosk_->servo(), signal);
        });
        ASSERT_TRUE(from_s);
        expect_free_for_good(*from_s);
    }

    /// The guard starts another servo, which has the motors tried anew before any force.
    void expect_a_new_trial(int signal) {
        const auto from_s = end_while_pulling([&] { signal_one(kiosk_->servo(), signal); });
        ASSERT_TRUE(from_s);
        const int tries = tries_;
        ASSERT_TRUE(kiosk_->looks_until([&] { return tries_ > tries; })) << kiosk_->told();
        expect_free_after(*from_s);
        const double asked_s = now_s();
        ASSERT_TRUE(kiosk_->looks_until([&] { return is_tried(); })) << kiosk_->told();
        const auto trial = changes_since(asked_s);
        EXPECT_FALSE(std::ranges::all_of(trial, is_at_rest)) << "the motors were tried";
        for (const BridgeChange& change : trial) {
            EXPECT_TRUE(change.torques.x == 0.0 || change.torques.y == 0.0);
            EXPECT_LE(norm(change.torques), most_nudge_Nm + 1e-6);
        }
        EXPECT_TRUE(end_while_pulling([] {})) << "the force comes back";
    }

    [[nodiscard]] double now_s() {
        return peer_.with([](double now_s) { return now_s; });
    }

    Machine machine_{nobody_holds_it(), Machine::units(), hand_in_the_middle()};
    SharedPeer peer_{machine_.peer()};
    SocketHost host_{peer_};
    std::optional<MakeKiosk> kiosk_;
    std::string file_;
    int tries_ = 0;  // of the motors

  private:
    bool lets_go_ = true;  // as the machine begins
    bool was_asked_ = false;
};

using ProcessMachines = testing::Types<MoteusMachine, OdriveMachine>;
TYPED_TEST_SUITE(MotorsProcess, ProcessMachines);

TYPED_TEST(MotorsProcess, TheWatchdogsLetGoIfTheWholeComputerStops) {
    this->expect_free_without_a_guard(SIGSTOP);
}

TYPED_TEST(MotorsProcess, TheWatchdogsLetGoOfAKilledServoWithoutAGuard) {
    this->expect_free_without_a_guard(SIGKILL);
}

/// A controller's own words reach the log, not only that the device was lost.
TYPED_TEST(MotorsProcess, AControllerThatFailsIsToldInItsWords) {
    const auto from_s = this->end_while_pulling([this] { this->machine_.fail(1); });
    ASSERT_TRUE(from_s);
    EXPECT_TRUE(this->kiosk_->looks_until([this] {
        return this->kiosk_->told().find(TypeParam::fault_words()) != std::string::npos;
    })) << this->kiosk_->told();
    this->expect_free_after(*from_s);
}

TYPED_TEST(MotorsProcess, AKilledServoIsFollowedByOneThatTriesTheMotorsAnew) {
    this->expect_a_new_trial(SIGKILL);
}

TYPED_TEST(MotorsProcess, AFrozenServoIsFollowedByOneThatTriesTheMotorsAnew) {
    this->expect_a_new_trial(SIGSTOP);
}

}  // namespace
}  // namespace touchline
