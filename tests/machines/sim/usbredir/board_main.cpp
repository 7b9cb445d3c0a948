// redirected_board SOCKET [UNPLUG_AFTER_WRITES | led PACE]: an emulated 2diy gen 3.1 for QEMU's
// usb-redir device, which connects to the unix socket. After that many writes the plug is pulled,
// once, and put back when QEMU connects again. `led`: hand and plug follow orders on stdin
// (board_orders.h), and both live PACE seconds in a second; without that, an emulated machine that
// runs slower than it believes sees the hand leap. Ends when QEMU has gone; prints the torque that
// the board was left with.
#include "tests/machines/sim/board/board_rig.h"
#include "tests/machines/sim/usbredir/board_orders.h"
#include "tests/machines/sim/usbredir/redirected_device.h"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include <sys/socket.h>

namespace {

using namespace touchline;

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
