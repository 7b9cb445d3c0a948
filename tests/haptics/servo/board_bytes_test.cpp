// The bytes that the present board is sent in a session, against those recorded before the servo
// knew other devices: same scene, same hand, on the virtual clock.
#include "haptics/servo/servo_loop.h"
#include "tests/haptics/servo/rigs.h"
#include "tests/machines/sim/board/board_rig.h"

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

const std::string recorded_file = TOUCHLINE_SOURCE_DIR "/tests/data/board_bytes.txt";

constexpr Position session_start{0.0, -0.015};

/// Waits until force is armed, presses into the line and along it past the corner, lifts, and goes
/// across again.
std::shared_ptr<const IntendedPath> session_path() {
    return std::make_shared<WaypointPath>(
        std::vector<WaypointPath::Waypoint>{{0.0, session_start},
                                            {0.9, session_start},
                                            {1.1, {-0.008, 0.006}},
                                            {1.5, {0.01, 0.008}},
                                            {1.6, {0.012, -0.01}},
                                            {1.8, {0.008, 0.012}}});
}

/// A line with a corner, so that forces have both directions.
std::shared_ptr<const Scene> bent_scene() {
    TactileMap map;
    Outline bent;
    bent.points = {{-0.05, 0.004}, {0.0, 0.0}, {0.05, 0.012}};
    map.outlines.push_back(bent);
    map.version = 1;
    return std::make_shared<const Scene>(build_scene(map, {}, 0.005).value());
}

std::string hex(std::span<const std::uint8_t> bytes) {
    constexpr const char* digits = "0123456789abcdef";
    std::string text;
    for (const std::uint8_t byte : bytes) {
        text += digits[byte >> 4U];
        text += digits[byte & 15U];
    }
    return text;
}

/// A line for each command; how often a command was sent in a row, and its bytes.
std::vector<std::string> lines_of(const std::vector<PacketBytes>& commands) {
    std::vector<std::pair<int, std::string>> runs;
    for (const PacketBytes& command : commands) {
        const std::string bytes = hex(command);
        if (runs.empty() || runs.back().second != bytes) runs.emplace_back(0, bytes);
        ++runs.back().first;
    }
    std::vector<std::string> lines;
    for (const auto& [count, bytes] : runs) lines.push_back(std::to_string(count) + ' ' + bytes);
    return lines;
}

/// The whole session: set-up, a wall, a garbled reply, a groove, a reply that comes too late, force
/// wanted off while the hand presses, a board that forgets its set-up.
std::vector<std::string> bytes_of_a_session() {
    const DeviceProfile& profile = default_profile();
    Calibration calibration;
    calibration.offset = angles_at(profile, session_start) - profile.home;
    BoardRig rig({}, {}, calibration, session_path());
    if (!rig.driver->open()) return {};
    ServoExchange exchange;
    Recorder recorder{0};
    ServoLoop loop{*rig.driver, profile, rig_tick_s, exchange, recorder};
    exchange.feel(bent_scene());
    ServoCommands commands;
    for (int tick = 0; tick < 1900; ++tick) {
        if (tick == 1300) rig.link->spoil_next({0, LinkFault::garbled_reply, 0.0, 1});
        if (tick == 1700) rig.link->spoil_next({0, LinkFault::late_reply, 0.008, 1});
        if (tick == 1860) rig.link->spoil_next({0, LinkFault::reset_board, 0.0, 1});
        commands.contact.mode = tick < 1400 ? Mode::wall : Mode::groove;
        commands.is_force_wanted = tick < 1800;
        exchange.set(commands);
        rig.time.now_s += rig_tick_s;
        loop.tick(rig_tick_s * tick, 0);
    }
    return lines_of(rig.link->commands());
}

std::vector<std::string> recorded_lines() {
    std::ifstream file(recorded_file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
}

TEST(BoardBytes, AreThoseOfBeforeThereWereOtherDevices) {
    const std::vector<std::string> sent = bytes_of_a_session();
    const char* const to = std::getenv("TOUCHLINE_BOARD_BYTES");  // NOLINT(concurrency-mt-unsafe)
    if (to != nullptr) {
        std::ofstream file(to);
        for (const std::string& line : sent) file << line << '\n';
    }
    const std::vector<std::string> recorded = recorded_lines();
    ASSERT_GT(recorded.size(), 300U) << "the session has contact";
    ASSERT_EQ(sent.size(), recorded.size());
    for (std::size_t i = 0; i < sent.size(); ++i)
        ASSERT_EQ(sent[i], recorded[i]) << "line " << i + 1;
}

}  // namespace
}  // namespace touchline
