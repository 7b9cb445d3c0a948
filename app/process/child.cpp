#include "app/servo/child.h"

#include <csignal>
#include <cstring>

#include <sched.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

// This C library forgets to say so itself.
extern "C" {
#include <sys/pidfd.h>
}

namespace touchline {
namespace {

constexpr int socket_over_there = 3;

/// How the child begins: its socket as number 3, no other descriptor, signals as usual.
class SpawnOrder {
  public:
    explicit SpawnOrder(int socket) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_adddup2(&actions_, socket, socket_over_there);
        posix_spawn_file_actions_addclosefrom_np(&actions_, socket_over_there + 1);
        posix_spawnattr_init(&attributes_);
        sigset_t none;
        sigemptyset(&none);
        sigset_t all;
        sigfillset(&all);
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setsigdefault(&attributes_, &all);
        const sched_param ordinary{};  // the guard's own priority is not for its child
        posix_spawnattr_setschedpolicy(&attributes_, SCHED_OTHER);
        posix_spawnattr_setschedparam(&attributes_, &ordinary);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF |
                                                   POSIX_SPAWN_SETSCHEDULER);
    }

    ~SpawnOrder() {
        posix_spawnattr_destroy(&attributes_);
        posix_spawn_file_actions_destroy(&actions_);
    }

    SpawnOrder(const SpawnOrder&) = delete;
    SpawnOrder(SpawnOrder&&) = delete;
    SpawnOrder& operator=(const SpawnOrder&) = delete;
    SpawnOrder& operator=(SpawnOrder&&) = delete;

    /// The error's number, 0 where there was none.
    int spawn(pid_t& pid, const std::string& program, std::vector<char*>& words) const {
        return posix_spawn(&pid, program.c_str(), &actions_, &attributes_, words.data(), environ);
    }

  private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

}  // namespace

Result<Child> Child::start(const std::string& program, const std::vector<std::string>& arguments,
                           const Descriptor& socket) {
    std::vector<std::string> texts{program, std::to_string(socket_over_there)};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<char*> words;
    for (std::string& text : texts) words.push_back(text.data());
    words.push_back(nullptr);
    pid_t pid = 0;
    if (const int error = SpawnOrder(socket.number()).spawn(pid, program, words); error != 0) {
        return failure("the servo program " + program +
                       " cannot be started: " + std::strerror(error));
    }
    Descriptor pidfd(pidfd_open(pid, 0));
    if (!pidfd.is_open()) {
        ::kill(pid, SIGKILL);
        (void)waitpid(pid, nullptr, 0);
        return failure("this kernel is too old to watch over the servo: it lacks pidfd");
    }
    return Child(pid, std::move(pidfd));
}

std::string Child::reap() {
    int status = 0;
    if (waitpid(pid_, &status, 0) != pid_) return "unknown";
    if (WIFSIGNALED(status)) return "signal " + std::to_string(WTERMSIG(status));
    const int code = WEXITSTATUS(status);
    return code == 0 ? std::string() : "exit status " + std::to_string(code);
}

void Child::kill() const {
    (void)pidfd_send_signal(pidfd_.number(), SIGKILL, nullptr, 0);
}

}  // namespace touchline
