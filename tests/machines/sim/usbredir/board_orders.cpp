#include "tests/machines/sim/usbredir/board_orders.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <poll.h>
#include <unistd.h>

namespace touchline {

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

}  // namespace touchline
