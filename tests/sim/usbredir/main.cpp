// redirected_board SOCKET [UNPLUG_AFTER_WRITES]: an emulated 2diy gen 3.1 for QEMU's usb-redir
// device, which connects to the unix socket. After that many writes the plug is pulled, once, and
// put back when QEMU connects again. Ends when QEMU has gone; says on stdout what torque the board
// was left with.
#include "tests/sim/board/board_rig.h"
#include "tests/sim/usbredir/redirected_board.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace {

int listen_at(const char* path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path, sizeof address.sun_path - 1);
    const int listener = socket(AF_UNIX, SOCK_STREAM, 0);
    unlink(path);
    const bool is_listening =
        bind(listener, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0 &&
        listen(listener, 1) == 0;
    return is_listening ? listener : -1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2 || argc > 3) {
        std::fputs("usage: redirected_board SOCKET [UNPLUG_AFTER_WRITES]\n", stderr);
        return 2;
    }
    const int listener = listen_at(argv[1]);
    if (listener < 0) {
        std::perror("redirected_board");
        return 1;
    }
    touchline::BoardEmulator board({}, touchline::resting_hand(touchline::default_profile()));
    int unplug_after = argc > 2 ? std::atoi(argv[2]) : 0;
    for (;;) {
        touchline::RedirectedBoard(board, accept(listener, nullptr, nullptr), unplug_after).serve();
        if (board.is_plugged()) break;
        unplug_after = 0;
        std::puts("unplugged");
        board.plug();
    }
    const auto& changes = board.told_torques();
    const auto left = changes.empty() ? touchline::JointTorques{} : changes.back().torques;
    std::printf("left with %.4f %.4f N m after %zu changes; set up %llu times\n", left.x, left.y,
                changes.size(), static_cast<unsigned long long>(board.firmware().set_ups()));
    return left == touchline::JointTorques{} ? 0 : 1;
}
