// jitter board|libusb SECONDS: runs the servo at 1 kHz on the emulated board, in the same process
// or through libusb (under umockdev-wrapper), for so long; prints one row of the table of
// tests/machines/sim/README.md.
#include "haptics/device/board/usb_boards.h"
#include "haptics/servo/servo.h"
#include "tests/haptics/servo/rigs.h"
#include "tests/machines/sim/board/board_rig.h"
#include "tests/machines/sim/umockdev/mocked_board.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <unistd.h>

namespace touchline {
namespace {

constexpr std::array<std::size_t, 9> bounds_us{20, 50, 100, 200, 500, 1000, 2000, 5000, 10000};

/// The driver on an emulated board in this process, in real time.
class BoardInProcess final : public JointDevice {
  public:
    BoardInProcess() : JointDevice(default_profile().geometry) {
        if (!rig_.driver->open()) std::abort();
        start_s_ = rig_.time.now_s;
    }

    [[nodiscard]] std::optional<JointAngles> read_angles(double now_s) override {
        rig_.time.now_s = start_s_ + now_s;
        return rig_.driver->read_angles(now_s);
    }

    [[nodiscard]] bool write_torques(JointTorques torques) override {
        return rig_.driver->write_torques(torques);
    }

  private:
    BoardRig rig_;
    double start_s_ = 0.0;
};

std::unique_ptr<ForceDevice> board_through(const UsbBoards& usb) {
    const auto known = read_boards(TOUCHLINE_SOURCE_DIR "/config/defaults/boards.toml");
    OpenedBoard opened = usb.open(usb.find(known->boards, "").value()).value();
    auto board =
        std::make_unique<PantographBoard>(std::move(opened.link), default_profile(), Calibration{});
    if (!board->open()) std::abort();
    return board;
}

void print(const std::string& way, const Servo& servo) {
    const LatenessHistogram& late = servo.lateness();
    std::printf("| %s | %s | %.1s | %llu |", way.c_str(), geteuid() == 0 ? "root" : "ordinary",
                describe(servo.tier().value()).data(),
                static_cast<unsigned long long>(late.count()));
    std::uint64_t below = 0;
    for (const std::size_t bound_us : bounds_us) {
        const std::uint64_t now = late.count_below(bound_us);
        std::printf(" %llu |", static_cast<unsigned long long>(now - below));
        below = now;
    }
    std::printf(" %llu | %d / %d / %d |\n", static_cast<unsigned long long>(late.count() - below),
                late.quantile_us(0.5), late.quantile_us(0.999), late.quantile_us(1.0));
}

int run(const std::string& way, int seconds) {
    std::optional<MockedUsb> mocked;
    std::optional<MockedBoard> board;
    std::optional<UsbBoards> usb;
    std::unique_ptr<ForceDevice> device;
    if (way == "libusb") {
        board.emplace(mocked.emplace(), BoardTruth{});
        usb = UsbBoards::create().value();
        device = board_through(*usb);
    } else {
        device = std::make_unique<BoardInProcess>();
    }
    Servo servo;
    servo.feel(line_scene(0.0));
    ServoOptions options;
    options.has_motors = true;
    if (!servo.start(std::move(device), default_profile(), options)) return 1;
    MonotonicClock clock;
    const std::int64_t end_ns = clock.now_ns() + std::int64_t{seconds} * 1'000'000'000;
    while (clock.now_ns() < end_ns) {
        clock.sleep_until(clock.now_ns() + 16'000'000);  // as the kiosk does each frame
        (void)servo.latest();
    }
    print(way == "libusb" ? way : "in process", servo);
    device = servo.stop();
    device.reset();
    return 0;
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    const std::string way = argc == 3 ? argv[1] : "";
    if (way != "board" && way != "libusb") {
        std::fputs("usage: jitter board|libusb SECONDS\n", stderr);
        return 2;
    }
    return touchline::run(way, std::atoi(argv[2]));
}
