// redirected_board SOCKET [UNPLUG_AFTER_WRITES | led PACE]: an emulated 2diy gen 3.1 for QEMU's
// usb-redir device, which connects to the unix socket. After that many writes the plug is pulled,
// once, and put back when QEMU connects again. `led`: hand and plug follow orders on stdin
// (BoardOrders), and both live PACE seconds in a second; without that, an emulated machine that
// runs slower than it believes sees the hand leap. Ends when QEMU has gone; prints the torque that
// the board was left with.
#include "tests/app/force/device/person.h"
#include "tests/machines/sim/board/board_emulator.h"
#include "tests/machines/sim/board/board_rig.h"
#include "tests/machines/sim/usbredir/redirected_device.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace {

using namespace touchline;

/// What a test tells the emulated board and the hand at it while it serves: lines on stdin.
///
///     hear WORDS     the hand does what homing says
///     go X Y         the hand goes there, in W, millimetres
///     unplug, plug   the cable
///     tell           a line on stdout: the largest torque told since the last one, and where the
///                    handle is
class BoardOrders {
  public:
    BoardOrders(BoardEmulator& board, std::shared_ptr<Person> person)
        : board_(board), person_(std::move(person)) {}

    /// Follows the orders that have come; does not wait.
    void follow();

    /// Waits until `plug` comes; returns false if nobody is left to send it.
    [[nodiscard]] bool wait_for_plug();

  private:
    void follow(const std::string& line);
    void tell();

    BoardEmulator& board_;
    std::shared_ptr<Person> person_;
    std::string rest_;  // incomplete line
    std::size_t told_ = 0;
    bool has_ended_ = false;  // stdin has ended
};

void BoardOrders::follow() {
    pollfd wanted{STDIN_FILENO, POLLIN, 0};
    while (!has_ended_ && poll(&wanted, 1, 0) > 0) {
        char bytes[256];
        const ssize_t got = read(STDIN_FILENO, bytes, sizeof bytes);
        has_ended_ = got <= 0;
        if (got > 0) rest_.append(bytes, static_cast<std::size_t>(got));
        for (std::size_t end = 0; (end = rest_.find('\n')) != std::string::npos;) {
            follow(rest_.substr(0, end));
            rest_.erase(0, end + 1);
        }
    }
}

bool BoardOrders::wait_for_plug() {
    while (!board_.is_plugged() && !has_ended_) {
        follow();
        poll(nullptr, 0, 10);
    }
    return board_.is_plugged();
}

void BoardOrders::follow(const std::string& line) {
    double x_mm = 0.0;
    double y_mm = 0.0;
    if (line.rfind("hear ", 0) == 0) person_->hear(line, board_.now_s());
    if (std::sscanf(line.c_str(), "go %lf %lf", &x_mm, &y_mm) == 2)
        person_->go({0.001 * x_mm, 0.001 * y_mm}, board_.now_s());
    if (line == "unplug") board_.unplug();
    if (line == "plug") board_.plug();
    if (line == "tell") tell();
}

void BoardOrders::tell() {
    const auto& changes = board_.told_torques();
    double largest_Nm = 0.0;
    for (; told_ < changes.size(); ++told_) {
        const JointTorques torques = changes[told_].torques;
        largest_Nm = std::max({largest_Nm, std::abs(torques.x), std::abs(torques.y)});
    }
    const Position handle = board_.plant().tip().position;
    std::printf("torque %.4f at %.1f %.1f\n", largest_Nm, 1000.0 * handle.x, 1000.0 * handle.y);
    std::fflush(stdout);
}

/// The board; its plug is pulled at a certain write.
class BoardFunction : public RedirectedFunction {
  public:
    /// `orders`: null if nobody gives any.
    BoardFunction(BoardEmulator& board, int unplug_after_writes, BoardOrders* orders, double pace)
        : board_(board),
          writes_until_unplugged_(unplug_after_writes),
          orders_(orders),
          pace_(pace) {}

    [[nodiscard]] std::uint8_t speed() const override { return usb_redir_speed_full; }

    [[nodiscard]] PacketBytes device() const override { return device_descriptor(board_); }

    [[nodiscard]] PacketBytes configuration() const override {
        return configuration_descriptor(board_);
    }

    [[nodiscard]] std::optional<PacketBytes> control(const UsbRequest& request,
                                                     std::span<const std::uint8_t> data) override {
        return answer(board_, request, data);
    }

    void listens(bool is_listening) override { board_.host_listens(is_listening); }

    void sends(std::span<const std::uint8_t> data) override {
        if (writes_until_unplugged_ > 0 && --writes_until_unplugged_ == 0) return board_.unplug();
        board_.host_sends(data);
    }

    [[nodiscard]] std::optional<PacketBytes> take(std::size_t /*most_bytes*/) override {
        auto packet = board_.take_packet();
        return packet ? std::optional(std::move(packet->bytes)) : std::nullopt;
    }

    void advance_to(double now_s) override {
        if (!start_s_) start_s_ = pace_ * now_s - board_.now_s();
        board_.advance_to(pace_ * now_s - *start_s_);
        if (orders_ != nullptr) orders_->follow();
    }

    [[nodiscard]] bool is_plugged() const override { return board_.is_plugged(); }

  private:
    BoardEmulator& board_;
    int writes_until_unplugged_;
    BoardOrders* orders_;
    double pace_;
    std::optional<double> start_s_;
};

/// Serves until QEMU has gone. Without orders the plug is put back at once.
void serve(int listener, BoardEmulator& board, int unplug_after, BoardOrders* orders, double pace) {
    for (;;) {
        BoardFunction function(board, unplug_after, orders, pace);
        RedirectedDevice(function, accept(listener, nullptr, nullptr)).serve();
        if (board.is_plugged()) return;
        unplug_after = 0;
        std::puts("unplugged");
        std::fflush(stdout);
        if (orders == nullptr) board.plug();
        if (orders != nullptr && !orders->wait_for_plug()) return;
    }
}

/// Prints what the board was left with and returns the exit status.
int say_what_is_left(const BoardEmulator& board) {
    const auto& changes = board.told_torques();
    const auto left = changes.empty() ? JointTorques{} : changes.back().torques;
    std::printf("left with %.4f %.4f N m after %zu changes; set up %llu times\n", left.x, left.y,
                changes.size(), static_cast<unsigned long long>(board.firmware().set_ups()));
    return left == JointTorques{} ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    const bool is_led = argc == 4 && argv[2] == std::string_view("led") && std::atof(argv[3]) > 0.0;
    const int unplug_after = argc == 3 ? std::atoi(argv[2]) : 0;
    if (!is_led && argc != 2 && unplug_after <= 0) {
        std::fputs("usage: redirected_board SOCKET [UNPLUG_AFTER_WRITES | led PACE]\n", stderr);
        return 2;
    }
    const int listener = listen_at(argv[1]);
    if (listener < 0) {
        std::perror("redirected_board");
        return 1;
    }
    if (is_led) {
        const auto person = std::make_shared<Person>(default_profile());
        BoardEmulator board({}, person);
        BoardOrders orders(board, person);
        serve(listener, board, 0, &orders, std::atof(argv[3]));
        return say_what_is_left(board);
    }
    BoardEmulator board({}, resting_hand(default_profile()));
    serve(listener, board, unplug_after, nullptr, 1.0);
    return say_what_is_left(board);
}
