// Tests that the emulated firmware does what the published one does: every test of the driver
// relies on that.
#include "tests/machines/sim/board/firmware.h"

#include "haptics/device/board/board_frame.h"
#include "haptics/device/board/hapi.h"
#include "tests/machines/sim/board/board_rig.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using Replies = std::vector<PacketBytes>;

/// The firmware alone, with encoders that a test turns.
struct Bench {
    explicit Bench(BoardType type = BoardType::m0) : firmware(type, 7) {}

    Replies run_to(double t_s) {
        Replies replies;
        while (firmware.next_pass_s() <= t_s) {
            last_pass_s = firmware.next_pass_s();
            if (auto reply = firmware.pass(last_pass_s, counts)) replies.push_back(*reply);
        }
        return replies;
    }

    Replies tell(const PacketBytes& bytes) {
        firmware.take(bytes, now_s);
        now_s += 0.01;
        return run_to(now_s);
    }

    Replies tell(const Command& command) {
        return tell(PacketBytes(command.bytes().begin(), command.bytes().end()));
    }

    void set_up(const char* profile = "2diy-gen3.1") {
        const BoardFrame frame(find_profile(profile).value(), {});
        EXPECT_TRUE(tell(set_up_command(frame.set_up_at_home())).empty());
    }

    Firmware firmware;
    PortCounts counts{};
    double now_s = 0.0;
    double last_pass_s = 0.0;
};

TEST(Firmware, ResetAndSetUpAreNotAnswered) {
    Bench bench;
    EXPECT_TRUE(bench.tell(reset_command()).empty());
    bench.set_up();
    EXPECT_TRUE(bench.firmware.is_set_up());
    EXPECT_TRUE(bench.tell(reset_command()).empty());
    EXPECT_FALSE(bench.firmware.is_set_up());
}

TEST(Firmware, FirstReplyAtHomeIsThePublishedOne) {
    Bench gen31;
    gen31.set_up();
    EXPECT_EQ(gen31.tell(write_command({})),
              (Replies{{0x05, 0x8f, 0x36, 0x3f, 0x41, 0xd2, 0xe6, 0x27, 0x43}}));
    Bench gen2;
    gen2.set_up("2diy-gen2");
    EXPECT_EQ(gen2.tell(write_command({})),
              (Replies{{0x05, 0x00, 0xc0, 0x73, 0xc2, 0x00, 0xf0, 0x70, 0x43}}));
}

TEST(Firmware, TheM0SeesHalfTheCountsTheDueAll) {
    const auto angle_after = [](BoardType type) {
        Bench bench(type);
        bench.set_up("haplet");
        bench.counts = {0, 100};
        return static_cast<double>(decode_reply(bench.tell(write_command({})).at(0)).angles.y);
    };
    EXPECT_NEAR(angle_after(BoardType::m0), 360.0 * 100.0 / 6912.0, 1e-5);
    EXPECT_NEAR(angle_after(BoardType::due), 360.0 * 100.0 / 13824.0, 1e-5);
}

TEST(Firmware, OneByteFromABoardThatIsNotSetUpThenTheTorquesAreCommands) {
    Bench bench;
    EXPECT_EQ(bench.tell(write_command({})), (Replies{{5}}));
    // 02 05 | 02 05 ...: the torque's own bytes ask again.
    EXPECT_EQ(bench.tell({2, 5, 2, 5, 9, 9, 2, 5, 9, 9}), (Replies{{5}, {5}, {5}}));
}

TEST(Firmware, UnknownBytesAreSwallowedOneByOne) {
    Bench bench;
    bench.set_up();
    EXPECT_EQ(bench.tell({7, 9, 200, 2, 5, 0, 0, 0, 0, 0, 0, 0, 0}).size(), 1U);
}

TEST(Firmware, BytesThatHaveNotComeReadAsFF) {
    Bench bench;
    bench.set_up();
    // 02 alone: the firmware reads the address as ff, which is not set up. It then swallows 05.
    EXPECT_EQ(bench.tell(PacketBytes{2}), (Replies{{0xff}}));
    EXPECT_TRUE(bench.tell(PacketBytes{5}).empty());
    EXPECT_EQ(bench.tell(write_command({})).size(), 1U);
}

TEST(Firmware, AWriteCutShortFreezesItForASecondWithTheOldTorqueThenIsGarbage) {
    Bench bench;
    bench.set_up();
    (void)bench.tell(write_command({0.05, -0.05}));
    const auto old_duty = bench.firmware.duty();
    const double cut_s = bench.now_s;
    EXPECT_TRUE(bench.tell({2, 5, 1, 2, 3}).empty());
    EXPECT_TRUE(bench.firmware.is_waiting());
    EXPECT_TRUE(bench.run_to(cut_s + 0.999).empty());
    EXPECT_EQ(bench.firmware.duty(), old_duty);
    EXPECT_EQ(bench.run_to(cut_s + 1.001).size(), 1U);
    EXPECT_NEAR(bench.last_pass_s, cut_s + 1.0, 1e-3);
    for (const double duty : bench.firmware.duty()) EXPECT_LE(std::abs(duty), 1.0);
}

TEST(Firmware, TheDueWaitsASecondForEachByte) {
    Bench bench(BoardType::due);
    bench.set_up("haplet");
    const double cut_s = bench.now_s;
    (void)bench.tell({2, 5, 1, 2, 3});
    bench.now_s = cut_s + 0.9;
    (void)bench.tell({4});
    EXPECT_TRUE(bench.run_to(cut_s + 1.8).empty());
    EXPECT_EQ(bench.run_to(cut_s + 1.91).size(), 1U);
}

TEST(Firmware, ZerosCompleteWhatItWaitsFor) {
    for (std::size_t sent = 1; sent < write_bytes; ++sent) {
        Bench bench;
        bench.set_up();
        (void)bench.tell(write_command({0.1, 0.1}));
        const Command whole = write_command({0.05, -0.05});
        const auto bytes = whole.bytes().first(sent);
        (void)bench.tell(PacketBytes(bytes.begin(), bytes.end()));
        EXPECT_EQ(bench.tell(completing_command(sent)).size(), sent == 1 ? 1U : 2U);
        EXPECT_EQ(bench.firmware.duty(), (std::array<double, port_count>{}));
        EXPECT_TRUE(bench.firmware.is_set_up());
    }
}

TEST(Firmware, SetUpStopsTheMotorsResetDoesNot) {
    Bench bench;
    bench.set_up();
    (void)bench.tell(write_command({0.123, -0.123}));
    EXPECT_EQ(bench.firmware.duty(), (std::array<double, port_count>{1.0, -1.0}));
    (void)bench.tell(reset_command());
    EXPECT_EQ(bench.firmware.duty(), (std::array<double, port_count>{1.0, -1.0}));
    bench.set_up();
    EXPECT_EQ(bench.firmware.duty(), (std::array<double, port_count>{}));
}

TEST(Firmware, DutyIsTruncatedToItsStepsAndClampedPerMotor) {
    Bench m0;
    m0.set_up();
    (void)m0.tell(write_command({0.05, -0.2}));
    EXPECT_DOUBLE_EQ(m0.firmware.duty()[0], std::trunc(1023.0 * 0.05 / 0.123) / 1023.0);
    EXPECT_EQ(m0.firmware.duty()[1], -1.0);
    Bench due(BoardType::due);
    due.set_up("haplet");
    (void)due.tell(write_command({0.05, -5.0}));
    EXPECT_DOUBLE_EQ(due.firmware.duty()[0], std::trunc(255.0 * 0.05 / 0.123) / 255.0);
}

TEST(Firmware, SetUpTakesFourMillisecondsAndAnswersLater) {
    Bench bench;
    bench.set_up();
    const double from_s = bench.now_s;
    const BoardFrame frame(default_profile(), {});
    const Command again = set_up_command(frame.set_up_at_home());
    bench.firmware.take(again.bytes(), from_s);
    bench.firmware.take(write_command({}).bytes(), from_s);
    EXPECT_TRUE(bench.run_to(from_s + 0.0039).empty());
    EXPECT_EQ(bench.run_to(from_s + 0.0043).size(), 1U);
}

TEST(Firmware, AddressZeroIsTheHostsMistake) {
    Bench bench;
    (void)bench.tell({2, 0});
    EXPECT_TRUE(bench.firmware.is_broken());
}

TEST(BoardEmulator, AnUnreadReplyStaysTheNextWaitsThenAllAreDropped) {
    BoardEmulator board({}, resting_hand(default_profile()));
    board.advance_to(0.01);
    for (int i = 0; i < 5; ++i) board.host_sends(write_command({}).bytes());
    board.advance_to(0.03);
    EXPECT_FALSE(board.take_packet().has_value());
    board.advance_to(0.2);
    board.host_listens(true);
    ASSERT_TRUE(board.take_packet().has_value());  // the first packet
    const auto empty = board.take_packet();
    ASSERT_TRUE(empty.has_value());
    EXPECT_TRUE(empty->bytes.empty());
    EXPECT_FALSE(board.take_packet().has_value());
}

TEST(BoardEmulator, DueIsMuteWhileTheLinesAreLow) {
    BoardTruth truth;
    truth.type = BoardType::due;
    truth.profile = find_profile("haplet").value();
    BoardEmulator board(truth, resting_hand(truth.profile));
    board.host_listens(true);
    board.host_sends(write_command({}).bytes());
    board.advance_to(0.01);
    EXPECT_FALSE(board.take_packet().has_value());
    board.set_lines(true, false);
    board.host_sends(write_command({}).bytes());
    board.advance_to(0.02);
    EXPECT_TRUE(board.take_packet().has_value());
}

TEST(BoardEmulator, AWrongPairOfDirectionsRunsAway) {
    const DeviceProfile profile = default_profile();
    const JointTorques told{0.02, 0.02};
    const auto torques_with = [&](Turn turn) {
        BoardEmulator board({}, resting_hand(profile));
        BoardSetUp set_up = BoardFrame(profile, {}).set_up_at_home();
        set_up.turns = {turn, turn};
        board.host_sends(set_up_command(set_up).bytes());
        board.advance_to(0.01);
        board.host_sends(write_command({told.x, told.y}).bytes());
        board.advance_to(0.02);
        return board.plant().torques();
    };
    EXPECT_GT(torques_with(Turn::counter_clockwise).x, 0.0);
    EXPECT_LT(torques_with(Turn::clockwise).x, 0.0);
}

}  // namespace
}  // namespace touchline
