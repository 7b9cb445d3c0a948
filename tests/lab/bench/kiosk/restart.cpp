// How soon a servo whose process is killed has its force back, with kiosk, servo and board as three
// processes, the board behind a file of the USB. Run it under umockdev-wrapper:
//
//   servo_restart_bench RUNS                  a row for each size of the picture
//   servo_restart_bench kiosk EDGES DEVICE    the kiosk of one run: prints the milliseconds from
//   the
//                                             kill until the force may act, or nothing
#include "app/force/device/board_files.h"
#include "app/force/servo/scene_order.h"
#include "app/force/servo/servo_process.h"
#include "app/force/servo/usb_search.h"
#include "app/isolation/process/child.h"
#include "config/types/steady_clock.h"
#include "tests/app/force/servo/usb_servo.h"
#include "tests/app/signal_one.h"
#include "tests/lab/bench/workload.h"
#include "tests/machines/sim/board/board_rig.h"
#include "tests/machines/sim/umockdev/mocked_board.h"
#include "tests/machines/sim/usbfs/usb_node_server.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr int device_number = 2;
constexpr int longest_wait_ms = 20'000;
constexpr int live_ms = 300;  // that the force has acted before the servo is killed
constexpr std::array<std::size_t, 3> sizes{64, 4096, 65536};

FeltPicture picture_of(std::size_t edges) {
    TactileMap map = workload::map_of(workload::curve(workload::Kind::radial, edges));
    map.version = 1;
    const SceneOrder order{};
    auto scene = build_scene(map, order).value();
    return {std::make_shared<const Scene>(std::move(scene)),
            std::make_shared<const TactileMap>(std::move(map)),
            order,
            {}};
}

bool may_act(ServoProcess& servo) {
    (void)servo.latest();
    const ForceState state = servo.force_status().state;
    return state == ForceState::ramp || state == ForceState::live;
}

/// Looks for the servo as the kiosk's frames do, only more often.
bool wait_until(ServoProcess& servo, const std::function<bool()>& condition) {
    for (int i = 0; i < longest_wait_ms; ++i) {
        if (condition()) return true;
        (void)servo.latest();
        poll(nullptr, 0, 1);
    }
    return false;
}

/// The only child of this process's threads.
pid_t servo_of_this_process() {
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
        std::ifstream children(task.path() / "children");
        if (pid_t child = 0; children >> child) return child;
    }
    return 0;
}

int run_kiosk(std::size_t edges, const std::vector<std::string>& words) {
    ServoProcess servo(usb_servo(TOUCHLINE_SERVO_RIG, device_of(words).value()));
    servo.feel(picture_of(edges));
    ServoCommands commands;
    commands.has_frame = false;  // home lies beyond the drawing area
    servo.set(commands);
    if (!wait_until(servo, [&servo] { return may_act(servo); })) return 1;
    const std::int64_t live_ns = steady_now_ns();
    (void)wait_until(servo,
                     [live_ns] { return steady_now_ns() - live_ns > 1'000'000LL * live_ms; });
    const std::int64_t killed_ns = steady_now_ns();
    signal_one(servo_of_this_process(), SIGKILL);
    if (!wait_until(servo, [&servo] { return !may_act(servo); })) return 1;
    if (!wait_until(servo, [&servo] { return may_act(servo); })) return 1;
    fmt::print("{:.3f}\n", 1e-6 * static_cast<double>(steady_now_ns() - killed_ns));
    servo.stop();
    return 0;
}

/// Runs a kiosk and returns what it printed, or nothing.
std::string said_by_kiosk(const std::vector<std::string>& words) {
    std::string command = "LD_PRELOAD=" TOUCHLINE_REAL_NODE_LIBRARY ":";
    command += std::string(std::getenv("LD_PRELOAD")) + " " + words.front();
    for (const std::string& word : std::span(words).subspan(1)) command += " '" + word + "'";
    std::FILE* const pipe = popen(command.c_str(), "r");
    std::array<char, 64> line{};
    const bool is_said = std::fgets(line.data(), line.size(), pipe) != nullptr;
    pclose(pipe);
    return is_said ? line.data() : "";
}

double load() {
    double load = 0.0;
    (void)getloadavg(&load, 1);
    return load;
}

double at_share(const std::vector<double>& sorted_ms, double share) {
    return sorted_ms[static_cast<std::size_t>(share * static_cast<double>(sorted_ms.size() - 1))];
}

std::uint64_t set_ups(UsbNodeServer& board) {
    std::uint64_t count = 0;
    board.with([&](BoardEmulator& emulator, UsbFaults&) { count = emulator.firmware().set_ups(); });
    return count;
}

int measure(int runs) {
    MockedUsb mocked;
    mocked.show(BoardEmulator({}, resting_hand(default_profile())), 1, device_number);
    const auto board =
        UsbNodeServer::create(mocked.folder() + MockedUsb::node_of(device_number), {});
    if (!board) return 1;
    UsbDevice device = find_usb_device(read_board_files(board_files()).value()).value().value();
    device.is_homed_first = false;  // the hand rests at home
    device.profile = default_profile().name;
    const std::string program = std::filesystem::read_symlink("/proc/self/exe");
    for (const std::size_t edges : sizes) {
        std::vector<double> times_ms;
        for (int i = 0; i < runs; ++i) {
            std::vector<std::string> words{program, "kiosk", std::to_string(edges)};
            for (const std::string& word : arguments_of(device)) words.push_back(word);
            const std::uint64_t before = set_ups(*board);
            const std::string said = said_by_kiosk(words);
            // The first servo sets it up; one that took it over does not.
            const bool is_taken_over = set_ups(*board) == before + 1;
            if (!said.empty() && is_taken_over) times_ms.push_back(std::stod(said));
        }
        std::ranges::sort(times_ms);
        if (times_ms.empty()) return 1;
        fmt::print("{},{},{:.0f},{:.0f},{:.0f},{:.1f}\n", edges, times_ms.size(),
                   at_share(times_ms, 0.5), at_share(times_ms, 0.9), at_share(times_ms, 1.0),
                   load());
        std::fflush(stdout);
    }
    return 0;
}

}  // namespace
}  // namespace touchline

int main(int count, char** words) {
    const std::vector<std::string> arguments(words + 1, words + count);
    if (arguments.size() == 1) return touchline::measure(std::stoi(arguments[0]));
    if (arguments.size() > 2 && arguments[0] == "kiosk")
        return touchline::run_kiosk(std::stoul(arguments[1]),
                                    {arguments.begin() + 2, arguments.end()});
    std::fprintf(stderr, "usage: servo_restart_bench RUNS\n");
    return 2;
}
