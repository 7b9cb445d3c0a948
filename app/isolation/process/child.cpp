#include "app/isolation/process/child.h"

#include "config/types/pinned.h"
#include "config/types/steady_clock.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <string_view>

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

// The headers of this C library lack this declaration.
extern "C" {
#include <sys/pidfd.h>
}

namespace touchline {
namespace {

/// How the child starts: with its handed descriptors and no others, and default signals.
class SpawnOrder : Pinned {
  public:
    SpawnOrder(std::span<const Descriptor* const> handed, StandardStreams streams) {
        posix_spawn_file_actions_init(&actions_);
        if (streams == StandardStreams::nothing) {
            for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
                posix_spawn_file_actions_addopen(&actions_, stream, "/dev/null", O_RDWR, 0);
        }
        hand(handed);
        posix_spawnattr_init(&attributes_);
        sigset_t none;
        sigemptyset(&none);
        sigset_t all;
        sigfillset(&all);
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setsigdefault(&attributes_, &all);
        const sched_param ordinary{};  // a thread's own priority must not pass to its child
        posix_spawnattr_setschedpolicy(&attributes_, SCHED_OTHER);
        posix_spawnattr_setschedparam(&attributes_, &ordinary);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF |
                                                   POSIX_SPAWN_SETSCHEDULER);
    }

    ~SpawnOrder() {
        posix_spawnattr_destroy(&attributes_);
        posix_spawn_file_actions_destroy(&actions_);
    }

    /// Returns the error's number; 0 for none.
    int spawn(pid_t& pid, const std::string& program, std::vector<char*>& words,
              std::vector<char*>& surroundings) const {
        return posix_spawn(&pid, program.c_str(), &actions_, &attributes_, words.data(),
                           surroundings.data());
    }

  private:
    /// Copies all above the wanted numbers first, because moving one down might close another.
    void hand(std::span<const Descriptor* const> handed) {
        int above = Child::first_handed + static_cast<int>(handed.size());
        for (const Descriptor* one : handed) above = std::max(above, one->number() + 1);
        int copy = above;
        for (const Descriptor* one : handed)
            posix_spawn_file_actions_adddup2(&actions_, one->number(), copy++);
        int number = Child::first_handed;
        for (int from = above; from < copy; ++from)
            posix_spawn_file_actions_adddup2(&actions_, from, number++);
        posix_spawn_file_actions_addclosefrom_np(&actions_, number);
    }

    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

/// As C takes them: with a null pointer at the end.
std::vector<char*> pointers_to(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

bool is_of_one_name(std::string_view a, std::string_view b) {
    return a.substr(0, a.find('=')) == b.substr(0, b.find('='));
}

std::vector<std::string> surroundings_with(const std::vector<std::string>& settings) {
    std::vector<std::string> all = settings;
    for (char** ours = environ; *ours != nullptr; ++ours) {
        const bool is_replaced = std::ranges::any_of(
            settings, [ours](const auto& setting) { return is_of_one_name(setting, *ours); });
        if (!is_replaced) all.emplace_back(*ours);
    }
    return all;
}

}  // namespace

std::string describe(const ChildEnd& end) {
    if (end.signal != 0) return "signal " + std::to_string(end.signal);
    return "exit status " + std::to_string(end.status);
}

Result<Child> Child::start(const std::string& program, const std::vector<std::string>& arguments,
                           std::span<const Descriptor* const> handed, StandardStreams streams,
                           const std::vector<std::string>& settings) {
    std::vector<std::string> texts{program};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<char*> words = pointers_to(texts);
    std::vector<std::string> around = surroundings_with(settings);
    std::vector<char*> surroundings = pointers_to(around);
    pid_t pid = 0;
    if (const int error = SpawnOrder(handed, streams).spawn(pid, program, words, surroundings);
        error != 0)
        return failure("the program " + program + " cannot be started: " + std::strerror(error));
    Descriptor pidfd(pidfd_open(pid, 0));
    if (!pidfd.is_open()) {
        ::kill(pid, SIGKILL);
        (void)waitpid(pid, nullptr, 0);
        return failure("this kernel is too old to watch over a process: it lacks pidfd");
    }
    return Child(pid, std::move(pidfd));
}

bool Child::ends_within(double seconds) const {
    const std::int64_t start_ns = steady_now_ns();
    pollfd dead{pidfd_.number(), POLLIN, 0};
    for (;;) {
        const double left_ms =
            1e3 * seconds - 1e-6 * static_cast<double>(steady_now_ns() - start_ns);
        const int wait_ms =
            std::isinf(seconds) ? -1 : static_cast<int>(std::max(0.0, std::ceil(left_ms)));
        const int found = ::poll(&dead, 1, wait_ms);
        if (found > 0) return true;
        if (found == 0 || errno != EINTR) return false;
    }
}

ChildEnd Child::reap() {
    int status = 0;
    if (waitpid(pid_, &status, 0) != pid_) return {-1, 0};
    if (WIFSIGNALED(status)) return {0, WTERMSIG(status)};
    return {WEXITSTATUS(status), 0};
}

void Child::kill() const {
    (void)pidfd_send_signal(pidfd_.number(), SIGKILL, nullptr, 0);
}

}  // namespace touchline
