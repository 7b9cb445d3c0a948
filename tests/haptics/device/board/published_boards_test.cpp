// Every kind of device as the maker's own programs and firmware handle it: 200 poses each, computed
// without this code (published_boards.csv), byte for byte.
#include "haptics/device/board/board_frame.h"
#include "haptics/device/board/hapi.h"
#include "haptics/pantograph/kinematics.h"
#include "tests/machines/sim/board/firmware.h"

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double degrees_per_radian = 57.295779513082320877;

struct PublishedCase {
    std::string kind;
    std::array<std::int64_t, 2> counts{};  // by port, in the direction that the port is told
    std::string reply;                     // the board's, at those counts
    JointAngles said;                      // degrees, as the maker's host takes them
    Position tip;
    JointTorques torques;
    std::string write;  // of the maker's host
};

std::vector<PublishedCase> published_cases() {
    std::ifstream file(TOUCHLINE_SOURCE_DIR "/tests/haptics/device/board/published_boards.csv");
    std::vector<PublishedCase> cases;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::istringstream row(line);
        std::vector<std::string> cells;
        for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
        cases.push_back({cells.at(0),
                         {std::stoll(cells.at(1)), std::stoll(cells.at(2))},
                         cells.at(3),
                         {std::stod(cells.at(4)), std::stod(cells.at(5))},
                         {std::stod(cells.at(6)), std::stod(cells.at(7))},
                         {std::stod(cells.at(8)), std::stod(cells.at(9))},
                         cells.at(10)});
    }
    return cases;
}

std::string hex(std::span<const std::uint8_t> bytes) {
    constexpr const char* digits = "0123456789abcdef";
    std::string text;
    for (const std::uint8_t byte : bytes) text += {digits[byte >> 4], digits[byte & 15]};
    return text;
}

/// Returns the emulated firmware's answer to a zero write after those counts.
PacketBytes emulated_reply(const PublishedCase& wanted, const BoardSetUp& set_up) {
    Firmware firmware(wanted.kind == "haplet" ? BoardType::due : BoardType::m0, 1);
    firmware.take(set_up_command(set_up).bytes(), 0.0);
    while (firmware.next_pass_s() < never_s) (void)firmware.pass(firmware.next_pass_s(), {});
    firmware.take(write_command({}).bytes(), 1.0);
    PortCounts counts{};
    for (std::size_t port = 0; port < 2; ++port)
        counts[port] =
            set_up.turns[port] == Turn::clockwise ? wanted.counts[port] : -wanted.counts[port];
    std::optional<PacketBytes> reply;
    while (!reply && firmware.next_pass_s() < never_s)
        reply = firmware.pass(firmware.next_pass_s(), counts);
    return reply.value_or(PacketBytes{});
}

PacketBytes bytes_of(const std::string& text) {
    PacketBytes bytes;
    for (std::size_t i = 0; i < text.size(); i += 2)
        bytes.push_back(static_cast<std::uint8_t>(std::stoi(text.substr(i, 2), nullptr, 16)));
    return bytes;
}

TEST(PublishedBoards, EveryKindIsSaidAndHeardByteForByte) {
    std::map<std::string, int> seen;
    for (const PublishedCase& wanted : published_cases()) {
        ++seen[wanted.kind];
        const DeviceProfile profile = find_profile(wanted.kind).value();
        const BoardFrame frame(profile, {});
        const PacketBytes emulated = emulated_reply(wanted, frame.set_up_at_home());
        ASSERT_EQ(hex(emulated), wanted.reply) << wanted.kind;
        const Reply reply = decode_reply(bytes_of(wanted.reply));
        ASSERT_EQ(reply.kind, ReplyKind::angles);
        ASSERT_TRUE(frame.is_whole_counts(reply.angles));
        const bool is_1_on_2 = profile.wiring.joint_1.port == 2;
        EXPECT_EQ(reply.angles.x, is_1_on_2 ? wanted.said.y : wanted.said.x);
        EXPECT_EQ(reply.angles.y, is_1_on_2 ? wanted.said.x : wanted.said.y);
        // The maker's host takes home as the board rounds it, this driver takes it as it is: up to
        // a count.
        const JointAngles angles = frame.joint_angles(reply.angles);
        EXPECT_NEAR(degrees_per_radian * angles.x, wanted.said.x, 0.16) << wanted.kind;
        EXPECT_NEAR(degrees_per_radian * angles.y, wanted.said.y, 0.16) << wanted.kind;
        const auto pose =
            forward(profile.geometry, along<JointAngles>(wanted.said, 1.0 / degrees_per_radian));
        ASSERT_TRUE(pose.has_value()) << wanted.kind;
        EXPECT_LT(norm(pose->p_DH - wanted.tip), 1e-8) << wanted.kind;
        EXPECT_EQ(hex(write_command(frame.port_torques(wanted.torques)).bytes()), wanted.write);
    }
    const std::map<std::string, int> expected{{"haplet", 200},
                                              {"2diy-gen2", 200},
                                              {"2diy-gen2-240", 200},
                                              {"2diy-gen3", 200},
                                              {"2diy-gen3.1", 200}};
    EXPECT_EQ(seen, expected);
}

}  // namespace
}  // namespace touchline
