#include "app/force/servo/running_servo.h"

#include "app/force/servo/messages.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>

// The headers of this C library lack this declaration.
extern "C" {
#include <sys/pidfd.h>
}

namespace touchline {
namespace {

constexpr int longest_answer_ms = 3000;

tl::unexpected<Error> nobody_at(const std::string& path, const std::string& why) {
    return failure("no servo comes from " + path + ": " + why);
}

Result<Descriptor> connected_to(const std::string& path) {
    sockaddr_un place{};
    place.sun_family = AF_UNIX;
    if (path.size() >= sizeof place.sun_path) return nobody_at(path, "the path is too long");
    path.copy(place.sun_path, path.size());
    Descriptor socket(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0));
    if (!socket.is_open() ||
        ::connect(socket.number(), reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0)
        return nobody_at(path, std::strerror(errno));
    return socket;
}

}  // namespace

void RunningServo::kill() const {
    (void)pidfd_send_signal(pidfd().number(), SIGKILL, nullptr, 0);
}

std::string RunningServo::end(bool has_said_done) {
    if (!child_) return has_said_done ? "" : "no farewell";
    const ChildEnd end = child_->reap();
    return end.is_good() ? "" : describe(end);
}

Result<StartedServo> start_servo(const std::string& program,
                                 const std::vector<std::string>& device) {
    auto sockets = socket_pair();
    if (!sockets) return tl::unexpected(sockets.error());
    std::vector<std::string> words{std::to_string(Child::first_handed)};  // its socket
    words.insert(words.end(), device.begin(), device.end());
    auto child = Child::start(program, words, std::array{&sockets->second});
    if (!child) return tl::unexpected(child.error());
    return StartedServo{RunningServo(std::move(*child)), std::move(sockets->first)};
}

Result<StartedServo> summon_servo(const std::string& path, const std::vector<std::string>& device) {
    auto socket = connected_to(path);
    if (!socket) return tl::unexpected(socket.error());
    pollfd waiting{socket->number(), POLLIN, 0};
    Arrival arrival;
    if (::poll(&waiting, 1, longest_answer_ms) <= 0 ||
        receive(*socket, arrival) != ReceiveStatus::received ||
        arrival.message.kind != MessageKind::here || !arrival.attached.is_open())
        return nobody_at(path, "whoever listens there does not answer");
    for (const std::string& word : device) {
        if (word.size() > sizeof Message::line ||
            !send(*socket, message_of(MessageKind::word, word)))
            return nobody_at(path, "it does not take the words of its device");
    }
    return StartedServo{RunningServo(std::move(arrival.attached)), std::move(*socket)};
}

}  // namespace touchline
