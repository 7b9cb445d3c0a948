// The servo program with a fake board, and a kiosk around it that does nothing else.
//
//   servo_rig SOCKET BOARD         the servo
//   servo_rig SOCKET usb DEVICE    the servo with a board on the USB, whatever its tier
//   servo_rig usb-kiosk DEVICE     its kiosk, with a hand that is pulled, until killed
//   servo_rig SOCKET make WORDS    the servo with a device of any make, whatever its tier
//   servo_rig make-kiosk MAKE PORT FILE    its kiosk as usb-kiosk, which tells what it hears
//   servo_rig kiosk BOARD [PATH]   the kiosk, until SIGTERM; asks at PATH for its servo; SIGUSR1:
//                                  keeps a recording; SIGUSR2: its main thread hangs for 0.8 s
//   servo_rig listen PATH          like systemd with touchline-servo.socket: starts a servo for
//                                  each request
//   servo_rig SOCKET               the servo started so: the kiosk names its board
#include "app/force/backends/kiosk_backends.h"
#include "app/force/backends/servo_backends.h"
#include "app/force/servo/servo_process.h"
#include "app/force/servo/servo_program.h"
#include "app/force/servo/usb_device.h"
#include "app/isolation/process/child.h"
#include "haptics/servo/real_time.h"
#include "tests/app/force/servo/fake_board.h"
#include "tests/app/force/servo/felt_line.h"
#include "tests/app/force/servo/mapped_file.h"
#include "tests/app/force/servo/usb_servo.h"
#include "tests/haptics/servo/rigs.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/un.h>

namespace touchline {
namespace {

constexpr Position above{0.0, 0.01};
constexpr Position pressed{0.0, -0.002};

void do_mischief(Mischief mischief) {
    if (mischief == Mischief::write_nowhere) *static_cast<volatile int*>(nullptr) = 1;
    if (mischief == Mischief::throw_something) throw std::runtime_error("a bug");
    // Volatile, because a compiler may assume that a loop without effects ends.
    for (volatile bool spins = mischief == Mischief::spin; spins;) {
    }
}

class FakeDevice final : public JointDevice {
  public:
    explicit FakeDevice(FakeBoard& board)
        : JointDevice(default_profile().geometry), board_(board) {}

    [[nodiscard]] std::optional<JointAngles> read_angles(double /*now_s*/) override {
        ++board_.reads;
        do_mischief(board_.mischief.exchange(Mischief::none));
        if (board_.is_silent != 0) return std::nullopt;
        // Moves at 0.12 m/s: a handle that leaps is a fault.
        const double down_m = above.y - pressed.y;
        const double goal_m = board_.is_pressed != 0 ? down_m : 0.0;
        moved_m_ += std::clamp(goal_m - moved_m_, -1.2e-4, 1.2e-4);
        return angles_at(default_profile(), above - Position{0.0, moved_m_});
    }

    [[nodiscard]] bool write_torques(JointTorques torques) override {
        board_.put(torques);
        return true;
    }

  private:
    FakeBoard& board_;
    double moved_m_ = 0.0;
};

void write_zero(void* device) noexcept {
    auto& board = *static_cast<FakeBoard*>(device);
    board.put({});
    ++board.zeroed_by_handler;
}

Result<OpenedDevice> open_fake_device(FakeBoard& board, const Opening& opening) {
    if (!board.is_free()) return failure("the board is busy");
    board.owner = getpid();
    board.reads = 0;
    MonotonicClock clock;
    while (board.is_tried != 0 && opening.goes_on()) {
        opening.mark_force(true);
        board.put({0.03, 0.0});
        clock.sleep_until(clock.now_ns() + 1'000'000);
    }
    board.put({});
    opening.mark_force(false);
    ++board.opened;
    const Descriptor node(::open("/dev/null", O_RDWR | O_CLOEXEC));
    opening.share({node.number(), {}, "1-1"});
    OpenedDevice opened;
    opened.device = std::make_unique<FakeDevice>(board);
    opened.profile = default_profile();
    opened.has_motors = false;  // as below
    opened.zero = {write_zero, &board};
    if (board.is_place_known != 0) opened.place = HandlePlace{};
    opened.release = [&board] { return board.is_zero_unconfirmed == 0; };
    return opened;
}

Result<ZeroedBoard> zero_by_guard(FakeBoard& board) {
    if (!board.is_free()) return failure("the board is busy");
    board.put({});
    ++board.zeroed_by_guard;
    return board.is_set_up_anew == 0 ? ZeroedBoard::kept : ZeroedBoard::unknown;
}

std::atomic<bool> is_end_asked{false}, is_recording_asked{false}, is_hang_asked{false};

int run_kiosk(const std::string& program, const std::string& board_path, const std::string& path) {
    FakeBoard& board = mapped<FakeBoard>(board_path);
    std::signal(SIGTERM, [](int) { is_end_asked = true; });
    std::signal(SIGUSR1, [](int) { is_recording_asked = true; });
    std::signal(SIGUSR2, [](int) { is_hang_asked = true; });
    ServoProcessOptions options{program,
                                {board_path},
                                [&board](const std::string&) { return zero_by_guard(board); },
                                {},
                                path};
    options.hand_over = [&board, board_path](const Handover&) {
        ++board.handed_over;
        return std::vector<std::string>{board_path};
    };
    ServoProcess servo(std::move(options));
    servo.feel(felt_line(0.0, 1));
    MonotonicClock clock;
    while (!is_end_asked) {
        (void)servo.latest();
        const std::string notice = servo.take_notice();
        if (!notice.empty()) std::fprintf(stderr, "%s\n", notice.c_str());
        if (is_recording_asked.exchange(false)) servo.keep_recording();
        const bool hangs = is_hang_asked.exchange(false);
        clock.sleep_until(clock.now_ns() + (hangs ? 800'000'000 : 16'000'000));
    }
    servo.stop();
    return 0;
}

/// Sets a groove a millimetre beside the hand whenever the force has come, which pulls it. Without
/// force the groove is far away, so that the force may come.
[[noreturn]] void pull_the_hand(ServoProcess& servo) {
    constexpr double far_m = 0.045;
    std::uint64_t version = 0;
    servo.feel(felt_line(far_m, ++version));
    ServoCommands commands;
    commands.contact.mode = Mode::groove;
    commands.has_frame = false;  // home lies beyond the drawing area
    servo.set(commands);
    MonotonicClock clock;
    std::string told;
    for (bool is_beside = false;; clock.sleep_until(clock.now_ns() + 2'000'000)) {
        const HandState& hand = servo.latest();
        const ForceState state = servo.force_status().state;
        const bool is_coming = state == ForceState::ramp;  // also while a groove is exchanged
        const bool is_live = state == ForceState::live;
        if (!is_coming && is_live != is_beside) {
            is_beside = is_live;
            servo.feel(felt_line(is_live ? hand.p_WH.y + 0.001 : far_m, ++version));
        }
        const std::string notice = servo.take_notice();
        if (!notice.empty()) std::fprintf(stderr, "%s\n", notice.c_str());
        const std::string words = servo.device_words();
        if (words != told) std::fprintf(stderr, "words: %s\n", words.c_str());
        told = words;
    }
}

int run_usb_kiosk(const std::string& program, const std::vector<std::string>& words) {
    ServoProcess servo(usb_servo(program, device_of(words).value()));
    pull_the_hand(servo);
}

int run_make_kiosk(const std::string& program, const std::string& make, const std::string& port,
                   const std::string& told) {
    if (std::freopen(told.c_str(), "a", stderr) == nullptr ||
        std::setvbuf(stderr, nullptr, _IONBF, 0) != 0)
        return 1;
    auto found = find_backend(make)->find(port);
    if (!found || !*found) {
        std::fprintf(stderr, "%s\n", found ? "not there" : found.error().line.c_str());
        return 1;
    }
    (*found)->servo.program = program;
    (*found)->servo.arguments.insert((*found)->servo.arguments.begin(), "make");
    ServoProcess servo(std::move((*found)->servo));
    pull_the_hand(servo);
}

/// Listens until it is killed. The kernel reaps its children.
int listen_at(const std::string& program, const std::string& path) {
    std::signal(SIGCHLD, SIG_IGN);
    const Descriptor socket(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0));
    sockaddr_un place{};
    place.sun_family = AF_UNIX;
    path.copy(place.sun_path, sizeof place.sun_path - 1);
    if (::bind(socket.number(), reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0 ||
        ::listen(socket.number(), 8) != 0)
        return 1;
    for (;;) {
        const Descriptor asking(::accept4(socket.number(), nullptr, nullptr, SOCK_CLOEXEC));
        if (!asking.is_open()) return 1;
        (void)Child::start(program, {std::to_string(Child::first_handed)}, std::array{&asking});
    }
}

/// A busy machine changes nothing.
Result<OpenedDevice> at_any_tier(Result<OpenedDevice> opened) {
    if (opened) opened->has_motors = false;
    return opened;
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    using namespace touchline;
    if (argc < 2) return 2;
    if (argc == 2) {
        return run_servo_program(std::stoi(argv[1]), [](const Opening& opening) {
            return open_fake_device(mapped<FakeBoard>(opening.words.at(0)), opening);
        });
    }
    if (std::string(argv[1]) == "usb-kiosk") return run_usb_kiosk(argv[0], {argv + 2, argv + argc});
    if (std::string(argv[1]) == "make-kiosk" && argc == 5)
        return run_make_kiosk(argv[0], argv[2], argv[3], argv[4]);
    const std::vector<std::string> device(argv + std::min(argc, 3), argv + argc);
    if (std::string(argv[2]) == "usb") {
        return run_servo_program(std::stoi(argv[1]), [&](const Opening& opening) {
            return at_any_tier(open_usb_device(device_of(device).value(), opening));
        });
    }
    if (std::string(argv[2]) == "make") {
        return run_servo_program(std::stoi(argv[1]), [&](const Opening& opening) {
            return at_any_tier(open_named_device(device, opening));
        });
    }
    if (std::string(argv[1]) == "kiosk")
        return run_kiosk(argv[0], argv[2], argc > 3 ? argv[3] : "");
    if (std::string(argv[1]) == "listen") return listen_at(argv[0], argv[2]);
    FakeBoard& board = mapped<FakeBoard>(argv[2]);
    return run_servo_program(std::stoi(argv[1]), [&board](const Opening& opening) {
        return open_fake_device(board, opening);
    });
}
