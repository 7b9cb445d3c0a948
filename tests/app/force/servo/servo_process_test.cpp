// Tests the servo as a real process, and a kiosk around it: the orders to both, and how a servo
// copes with a kiosk that is mad or gone. process_fault_test.cpp kills them.
#include "app/force/servo/servo_process.h"

#include "app/force/servo/messages.h"
#include "app/force/servo/running_servo.h"
#include "app/force/servo/servo_connection.h"
#include "app/isolation/process/child.h"
#include "config/types/map_bytes.h"
#include "tests/app/force/servo/process_rig.h"
#include "tests/app/signal_one.h"
#include "tests/audio-cues/words/po_file.h"

#include <atomic>
#include <cstddef>
#include <mutex>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <poll.h>

namespace touchline {
namespace {

using ServoProcess = ProcessRig;

TEST_F(ServoProcess, MakesForceAndEndsAsAsked) {
    start_kiosk();
    ASSERT_TRUE(press_on_servo(1));
    const int servo = board_.owner;
    EXPECT_EQ(end_kiosk(SIGTERM), 0);
    EXPECT_EQ(board_.is_torque_on, 0);
    EXPECT_EQ(board_.zeroed_by_guard, 0);  // it ended by itself
    EXPECT_NE(kill(servo, 0), 0);
}

/// What a guard relies on also holds while the motors are tried.
TEST_F(ServoProcess, TellsTheTorqueThatComesBeforeItsLoop) {
    board_.is_tried = 1;
    auto servo = start_servo(TOUCHLINE_SERVO_RIG, {path_}).value();
    const SharedRegion region = SharedRegion::create().value();
    ASSERT_TRUE(send(servo.socket, message_of(MessageKind::region), &region.descriptor()));
    ServoChannel& channel = region.channel();
    ASSERT_TRUE(wait_until([&] { return board_.is_torque_on == 1; }));
    EXPECT_EQ(channel.is_force_on, 1);
    EXPECT_EQ(channel.loop_process, board_.owner);
    EXPECT_GT(channel.loop_thread, 0);
    const int thread = channel.loop_thread;
    board_.is_tried = 0;
    ASSERT_TRUE(wait_until([&] { return board_.reads > 0; }));
    EXPECT_NE(channel.loop_thread, thread) << "the loop has a thread of its own";
    EXPECT_EQ(channel.is_force_on, 0);
    servo.peer.kill();
    (void)servo.peer.end(true);
}

/// A device that is set up anew after a long trial is not lost: its silence begins with the loop.
TEST_F(ServoProcess, ADeviceThatIsSilentAtFirstAfterALongTrialIsNotLost) {
    board_.is_tried = 1;
    board_.is_silent = 1;
    start_kiosk();
    ASSERT_TRUE(wait_until([&] { return board_.is_torque_on == 1; }));
    poll(nullptr, 0, 2500);  // longer than a device may be silent
    board_.is_tried = 0;
    ASSERT_TRUE(wait_for_ticks(200));
    board_.is_silent = 0;
    ASSERT_TRUE(press_on_servo(1));
    EXPECT_EQ(board_.opened, 1) << "the same servo";
}

class HandedOver : public ProcessRig {
  protected:
    /// Kills the servo with this number while it makes force, and waits for the next.
    void kill_servo(int number) {
        ASSERT_TRUE(press_on_servo(number));
        signal_one(board_.owner, SIGKILL);
        ASSERT_TRUE(wait_until([&] { return board_.opened > number && board_.reads > 0; }));
    }
};

TEST_F(HandedOver, AServoThatDiesIsFollowedAtOnceByOneThatTakesTheBoardOver) {
    board_.is_place_known = 1;
    start_kiosk();
    kill_servo(1);
    EXPECT_EQ(board_.handed_over, 1);
    EXPECT_GE(board_.zeroed_by_guard, 1) << "zero is confirmed before";
    EXPECT_TRUE(press()) << "force comes by the rule of arming, as after every start";
}

TEST_F(HandedOver, OneThatDiesAgainWithinAMinuteIsNotTrusted) {
    board_.is_place_known = 1;
    start_kiosk();
    kill_servo(1);
    kill_servo(2);
    EXPECT_EQ(board_.handed_over, 1);
}

TEST_F(HandedOver, NotWhereTheBoardHadToBeSetUp) {
    board_.is_place_known = 1;
    board_.is_set_up_anew = 1;
    start_kiosk();
    kill_servo(1);
    EXPECT_EQ(board_.handed_over, 0);
}

TEST_F(HandedOver, NotWhereNobodyHasSaidWhereTheHandleIs) {
    start_kiosk();
    kill_servo(1);
    EXPECT_EQ(board_.handed_over, 0);
}

TEST_F(ServoProcess, TheGuardZeroesABoardThatDidNotConfirmItAtTheEnd) {
    board_.is_zero_unconfirmed = 1;
    start_kiosk();
    ASSERT_TRUE(press_on_servo(1));
    EXPECT_EQ(end_kiosk(SIGTERM), 0);
    EXPECT_EQ(board_.is_torque_on, 0);
    EXPECT_EQ(board_.zeroed_by_guard, 1);
}

/// Otherwise each start of a servo that fails like the one before would be news of a repair, and of
/// a tier.
TEST_F(ServoProcess, WhyThereIsNoServoStaysToBeReadWhileTheNextIsTried) {
    board_.owner = getpid();  // the board is busy
    int failures = 0;
    int silences = 0;
    int tiers = 0;
    {
        touchline::ServoProcess servo(
            {TOUCHLINE_SERVO_RIG,
             {path_},
             [](const std::string&) { return Result<ZeroedBoard>(ZeroedBoard::unknown); },
             {},
             {}});
        EXPECT_TRUE(wait_until([&] {
            if (!servo.take_notice().empty()) ++failures;
            if (failures > 0 && servo.device_words().empty()) ++silences;
            if (servo.tier()) ++tiers;
            return failures == 3;
        }));
    }
    EXPECT_EQ(silences, 0);
    EXPECT_EQ(tiers, 0);
    board_.owner = 0;
}

/// Otherwise a board would count as working between the servo that it was unplugged from and the
/// next one, which finds none.
TEST(ServoConnection, TheDeviceIsLostFromAServosEndUntilMoreIsSaidOrTheNextReports) {
    ServoConnection line;
    ServoReport report;
    const auto fault = [&] {
        line.update(report, steady_now_ns());
        return report.force.fault;
    };
    const auto connect = [&] {
        auto connection = std::make_shared<const Connection>(
            Connection{SharedRegion::create().value(), Descriptor()});
        line.connect(connection);
        return connection;
    };
    EXPECT_EQ(fault(), Fault::none);  // not yet begun
    const auto first = connect();
    ServoReport told;
    told.force.fault = Fault::device_lost;
    first->region.channel().reports.write(told);
    EXPECT_EQ(fault(), Fault::device_lost);
    line.disconnect();
    EXPECT_EQ(fault(), Fault::device_lost);
    const auto second = connect();
    EXPECT_EQ(fault(), Fault::device_lost);  // the next one has told nothing yet
    line.say("No board is plugged in.");
    line.disconnect();
    EXPECT_EQ(fault(), Fault::none);  // the words replace the fault
    const auto third = connect();
    line.say("");
    line.disconnect();
    EXPECT_EQ(fault(), Fault::device_lost);
    const auto fourth = connect();
    EXPECT_EQ(fault(), Fault::device_lost);
    line.say("Move the handle to the left.");
    EXPECT_EQ(fault(), Fault::none);  // it is being homed: the words count
    fourth->region.channel().reports.write({});
    EXPECT_EQ(fault(), Fault::none);
}

/// Options for a board of unknown kind; it confirms zero after `failures` tries.
ServoProcessOptions without_kind(std::atomic<int>& zeroed, int failures) {
    ServoProcessOptions options{TOUCHLINE_SERVO_RIG, {}, [&zeroed, failures](const std::string&) {
                                    return ++zeroed > failures
                                               ? Result<ZeroedBoard>(ZeroedBoard::unknown)
                                               : failure("busy");
                                }};
    options.kind = "";
    return options;
}

/// Another program may have left torque on the board.
TEST_F(ServoProcess, ABoardIsToldZeroAndNoMoreBeforeItsKindIsSaid) {
    std::atomic<int> zeroed{0};
    ServoProcessOptions options = without_kind(zeroed, 1);
    options.keep_kind = [this](const std::string&) { return std::vector<std::string>{path_}; };
    touchline::ServoProcess servo(std::move(options));
    EXPECT_TRUE(wait_until([&] { return !servo.device_words().empty(); }));
    EXPECT_EQ(servo.device_words(), kind_wanted);
    poll(nullptr, 0, 4000);  // it has looked at 0, 0.5, 1.5 and 3.5 s, and looks next at 7.5 s
    EXPECT_EQ(zeroed, 2);
    EXPECT_EQ(board_.reads, 0);
    servo.choose_kind("haplet");
    const std::int64_t chosen_ns = steady_now_ns();
    EXPECT_EQ(servo.kind(), "haplet");
    bool is_old_said = false;
    EXPECT_TRUE(wait_until([&] {
        (void)servo.latest();
        is_old_said = is_old_said || servo.device_words() == kind_wanted;
        return board_.reads > 100;
    }));
    EXPECT_FALSE(is_old_said);
    EXPECT_LT(1e-9 * static_cast<double>(steady_now_ns() - chosen_ns), 2.0);
}

/// The first kind is still being written to the disk, and its servo starts.
TEST_F(ServoProcess, TheKindThatIsSaidLastHolds) {
    std::atomic<int> zeroed{0};
    std::mutex mutex;
    std::vector<std::string> kept;
    const auto last_kept = [&] {
        const std::lock_guard lock(mutex);
        return kept.empty() ? std::string() : kept.back();
    };
    ServoProcessOptions options = without_kind(zeroed, 0);
    options.keep_kind = [&](const std::string& kind) {
        {
            const std::lock_guard lock(mutex);
            kept.push_back(kind);
        }
        poll(nullptr, 0, 100);
        return std::vector<std::string>{path_};
    };
    touchline::ServoProcess servo(std::move(options));
    servo.choose_kind("haplet");
    ASSERT_TRUE(wait_until([&] { return last_kept() == "haplet"; }));
    servo.choose_kind("mk2");
    EXPECT_TRUE(wait_until([&] {
        (void)servo.latest();
        return last_kept() == "mk2";
    }));
    const std::uint64_t reads = board_.reads;
    EXPECT_TRUE(wait_until([&] {
        (void)servo.latest();
        return board_.reads > reads + 100;
    }));
}

/// The words tell what to do for the next servo, not what was to do for the last one.
TEST_F(ServoProcess, WordsAreOfTheHomingThatIsWanted) {
    touchline::ServoProcess servo({TOUCHLINE_SERVO_RIG, {path_}, [](const std::string&) {
                                       return Result<ZeroedBoard>(ZeroedBoard::unknown);
                                   }});
    const auto runs = [&](int opened) {
        return wait_until([&] {
            (void)servo.latest();
            return board_.opened == opened && board_.reads > 0 && servo.device_words().empty();
        });
    };
    ASSERT_TRUE(runs(1));
    servo.home_again();
    EXPECT_EQ(servo.device_words(), is_starting);
    EXPECT_TRUE(runs(2));
}

TEST(GuardWords, AreInTheCatalogue) {
    const PoFile english =
        read_po(TOUCHLINE_SOURCE_DIR "/audio-cues/words/catalogue/touchline.pot");
    for (const char* sentence : {"One moment.", "The handle is being started."}) {
        EXPECT_TRUE(english.contains({"device", sentence})) << sentence;
        EXPECT_NE(is_starting.find(sentence), std::string::npos);
    }
}

/// A corrupted kiosk scribbles over all shared memory, sends nonsense, and dies.
TEST_F(ServoProcess, AKioskGoneMadNeitherCrashesTheServoNorLeavesTorque) {
    auto sockets = socket_pair().value();
    auto region = SharedRegion::create().value();
    auto child =
        Child::start(TOUCHLINE_SERVO_RIG, {"3", path_}, std::array{&sockets.second}).value();
    sockets.second = Descriptor{};
    ASSERT_TRUE(send(sockets.first, message_of(MessageKind::region), &region.descriptor()));
    ASSERT_TRUE(wait_until([&] { return board_.reads > 100; }));
    std::mt19937 random(20261122);
    auto* const bytes = reinterpret_cast<volatile unsigned char*>(&region.channel());
    const std::size_t stop = offsetof(ServoChannel, is_stop_wanted);
    for (int round = 0; round < 200; ++round) {
        for (int i = 0; i < 2000; ++i) {
            const std::size_t at = random() % sizeof(ServoChannel);
            if (at != stop) bytes[at] = static_cast<unsigned char>(random());
        }
        Message message = message_of(static_cast<MessageKind>(round % 4));
        message.scene.radius_m = round % 3 == 0 ? -1.0 : 0.001;
        (void)send(sockets.first, message, round % 2 == 0 ? &region.descriptor() : nullptr);
        poll(nullptr, 0, 1);
    }
    const std::uint64_t reads = board_.reads;
    EXPECT_TRUE(wait_until([&] { return board_.reads > reads + 100; }));  // it ticks on
    sockets.first = Descriptor{};
    ASSERT_TRUE(child.ends_within(60.0));
    EXPECT_TRUE(child.reap().is_good());
    EXPECT_EQ(board_.is_torque_on, 0);
}

TEST_F(ServoProcess, ServoWithoutAKioskEnds) {
    auto sockets = socket_pair().value();
    auto child =
        Child::start(TOUCHLINE_SERVO_RIG, {"3", path_}, std::array{&sockets.second}).value();
    sockets.second = Descriptor{};
    sockets.first = Descriptor{};
    ASSERT_TRUE(child.ends_within(60.0));
    EXPECT_EQ(child.reap(), (ChildEnd{1, 0}));
    EXPECT_EQ(board_.opened, 0);
}

}  // namespace
}  // namespace touchline
