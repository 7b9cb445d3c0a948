#include "tests/app/braille/virtual_display.h"

#include "app/braille/translation.h"
#include "tests/app/signal_one.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// "Braille "1|12|14"": dots by their numbers, cells between bars.
std::string ascii_of_dots(std::string_view dots) {
    std::string text;
    unsigned int cell = 0;
    const auto put = [&] { text += braille_ascii(static_cast<std::uint8_t>(cell)), cell = 0; };
    for (const char c : dots) {
        if (c == '|') put();
        if (c >= '1' && c <= '8') cell |= 1U << static_cast<unsigned int>(c - '1');
    }
    put();
    return text.substr(0, text.find_last_not_of(' ') + 1);
}

int listen_at(const fs::path& path) {
    fs::remove(path);
    const int made = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    EXPECT_EQ(bind(made, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(listen(made, 1), 0);
    return made;
}

}  // namespace

VirtualDisplay::VirtualDisplay(const fs::path& folder, int columns)
    : socket_(folder / "display"),
      listener_(listen_at(socket_)),
      columns_(columns),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

VirtualDisplay::~VirtualDisplay() {
    thread_.request_stop();
    thread_.join();
    if (client_ >= 0) close(client_);
    close(listener_);
    fs::remove(socket_);
}

void VirtualDisplay::run(const std::stop_token& stop) {
    std::string rest;
    while (!stop.stop_requested()) {
        std::array<pollfd, 2> watched{pollfd{listener_, POLLIN, 0}, pollfd{client_, POLLIN, 0}};
        if (poll(watched.data(), watched.size(), 50) <= 0) continue;
        if ((watched[0].revents & POLLIN) != 0) {
            const std::lock_guard lock(mutex_);
            if (client_ >= 0) close(client_);
            client_ = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
            rest.clear();
            shown_.clear();
        }
        if ((watched[0].revents & POLLIN) != 0) send("cells " + std::to_string(columns_));
        if (watched[1].revents == 0) continue;
        std::array<char, 4096> bytes{};
        const ssize_t count = read(watched[1].fd, bytes.data(), bytes.size());
        if (count <= 0) {
            const std::lock_guard lock(mutex_);
            close(client_);
            client_ = -1;
            shown_.clear();
            continue;
        }
        rest.append(bytes.data(), static_cast<std::size_t>(count));
        for (auto end = rest.find('\n'); end != std::string::npos; end = rest.find('\n')) {
            take(rest.substr(0, end));
            rest.erase(0, end + 1);
        }
    }
}

void VirtualDisplay::take(const std::string& line) {
    constexpr std::string_view braille = "Braille \"";
    if (!line.starts_with(braille)) return;
    const std::size_t end = line.rfind('"');
    const std::lock_guard lock(mutex_);
    shown_ = ascii_of_dots(std::string_view(line).substr(braille.size(), end - braille.size()));
}

void VirtualDisplay::send(const std::string& line) {
    const std::string bytes = line + '\n';
    const std::lock_guard lock(mutex_);
    if (client_ >= 0) (void)::send(client_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
}

std::string VirtualDisplay::shown() const {
    const std::lock_guard lock(mutex_);
    return shown_;
}

bool VirtualDisplay::shows(const std::function<bool(const std::string&)>& is_right,
                           double most_s) const {
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(most_s);
    while (!is_right(shown())) {
        if (std::chrono::steady_clock::now() > until) return false;
        std::this_thread::sleep_for(10ms);
    }
    return true;
}

bool VirtualDisplay::shows(const std::string& text, double most_s) const {
    return shows([&text](const std::string& shown) { return shown == text; }, most_s);
}

std::string Brltty::program() {
    for (const char* path : {"/usr/bin/brltty", "/bin/brltty", "/usr/sbin/brltty", "/sbin/brltty"})
        if (fs::exists(path)) return path;
    return {};
}

Brltty::Brltty(const fs::path& folder, const std::string& host, const std::string& display_socket) {
    const std::string log = (folder / "brltty.log").string();
    std::vector<std::string> words{program(), "-n",         // no daemon
                                   "-f",      "/dev/null",  // nothing of this machine's settings
                                   "-F",      (folder / "preferences").string(),  //
                                   "-W",      folder.string(),
                                   "-U",      folder.string(),  // where it may write
                                   "-b",      "vr",
                                   "-d",      "client:" + display_socket,  // the display
                                   "-s",      "no",
                                   "-x",      "no",  // no speech, no screen
                                   "-A",      "host=" + host + ",auth=none",  // BrlAPI
                                   "-L",      log,
                                   "-l",      "debug",
                                   "-M",      "1"};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    EXPECT_EQ(posix_spawn(&pid_, words[0].c_str(), nullptr, nullptr, arguments.data(), environ), 0);
}

void Brltty::stop() {
    if (pid_ < 0) return;
    signal_one(pid_, SIGTERM);
    for (int i = 0; i < 300 && waitpid(pid_, nullptr, WNOHANG) == 0; ++i)
        std::this_thread::sleep_for(10ms);
    signal_one(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    pid_ = -1;
}

}  // namespace touchline
