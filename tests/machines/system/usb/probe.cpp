// board_probe BOARDS.toml TICKS: takes the only pantograph that is plugged in, drives it for TICKS
// milliseconds with a small torque and stops it. Exits with 0, with 3 if the board was lost on the
// way, or with 1 if there is none or it does not answer.
#include "haptics/device/board/usb_boards.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

namespace {

using namespace touchline;

constexpr std::chrono::milliseconds tick{1};
constexpr JointTorques push{0.02, -0.02};

int complain(const std::string& line) {
    std::printf("%s\n", line.c_str());
    return 1;
}

int drive(PantographBoard& driver, int ticks) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    int answered = 0;
    for (int k = 1; k <= ticks && driver.report().state != BoardState::lost; ++k) {
        std::this_thread::sleep_until(start + k * tick);
        const std::chrono::duration<double> now = Clock::now() - start;
        const auto angles = driver.read_angles(now.count());
        (void)driver.write_torques(angles ? push : JointTorques{});
        answered += angles ? 1 : 0;
    }
    const BoardReport& report = driver.report();
    const bool is_lost = report.state == BoardState::lost;
    const bool is_stopped = driver.stop();
    std::printf("angles in %d of %d ticks, %llu replies, %llu late, %llu resyncs; %s\n", answered,
                ticks, static_cast<unsigned long long>(report.replies),
                static_cast<unsigned long long>(report.late),
                static_cast<unsigned long long>(report.resyncs),
                is_lost      ? "lost"
                : is_stopped ? "stopped"
                             : "not stopped");
    if (is_lost) return 3;
    return is_stopped && answered > 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return complain("usage: board_probe BOARDS.toml TICKS");
    const auto settings = read_boards(argv[1]);
    if (!settings) return complain(settings.error().line);
    const auto usb = UsbBoards::create();
    if (!usb) return complain(usb.error().line);
    for (const FoundBoard& board : usb->list(settings->boards))
        std::printf("%s\n", describe(board).c_str());
    auto pantograph = take_pantograph(*usb, *settings, "", "2diy-gen3.1");
    if (!pantograph) return complain(pantograph.error().line);
    const auto opened = pantograph->driver->open();
    if (!opened) return complain(opened.error().line);
    return drive(*pantograph->driver, std::atoi(argv[2]));
}
