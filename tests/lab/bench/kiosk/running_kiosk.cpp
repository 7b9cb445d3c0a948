#include "tests/lab/bench/kiosk/running_kiosk.h"

#include "config/types/steady_clock.h"

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr int longest_start_ms = 60'000;
constexpr double longest_end_s = 10.0;

[[noreturn]] void give_up(const char* why) {
    std::fprintf(stderr, "kiosk_program_bench: %s\n", why);
    std::exit(1);
}

/// Where the kiosk says what it says to systemd: READY=1 once its first frame is shown.
class ReadySocket : private Pinned {
  public:
    ReadySocket() : socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
        sockaddr_un place{};
        place.sun_family = AF_UNIX;
        path_.copy(place.sun_path, sizeof place.sun_path - 1);
        std::filesystem::remove(path_);
        if (::bind(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0)
            give_up("no socket for the kiosk's sign that it is ready");
    }

    ~ReadySocket() {
        ::close(socket_);
        std::filesystem::remove(path_);
    }

    [[nodiscard]] const std::string& path() const { return path_; }

    /// Waits for READY=1.
    void wait() const {
        std::array<char, 64> text{};
        pollfd waiting{socket_, POLLIN, 0};
        while (::poll(&waiting, 1, longest_start_ms) > 0) {
            const ssize_t size = ::recv(socket_, text.data(), text.size(), 0);
            if (size > 0 && std::string(text.data(), static_cast<std::size_t>(size)) == "READY=1")
                return;
        }
        give_up("the kiosk did not become ready");
    }

  private:
    std::string path_ =
        std::filesystem::temp_directory_path() / ("touchline-ready-" + std::to_string(getpid()));
    int socket_;
};

Child started(const std::string& program, const std::vector<std::string>& files, double& start_s) {
    const ReadySocket ready;
    const std::int64_t start_ns = steady_now_ns();
    auto child =
        Child::start(program, files, {}, StandardStreams::ours, {"NOTIFY_SOCKET=" + ready.path()});
    if (!child) give_up(child.error().line.c_str());
    ready.wait();
    start_s = 1e-9 * static_cast<double>(steady_now_ns() - start_ns);
    return std::move(*child);
}

}  // namespace

RunningKiosk::RunningKiosk(const std::string& program, const std::vector<std::string>& files)
    : child_(started(program, files, start_s_)) {}

RunningKiosk::~RunningKiosk() {
    ::kill(child_.pid(), SIGTERM);
    if (!child_.ends_within(longest_end_s)) child_.kill();
    (void)child_.ends_within(longest_end_s);
    (void)child_.reap();
}

}  // namespace touchline
