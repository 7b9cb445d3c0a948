// Shuts itself in and then tries one act.
//
//   sandbox_probe STEPS KIND ACT    STEPS: all, files (Landlock alone), calls (seccomp alone),
//                                   none, system (only reading the system's files), without:CALL
//                                   (all, on a kernel that refuses the call), without:CALL/N
//                                   (that call with N as its first argument)
//
// Exit status: 0 the act worked, 1 it was refused, 2 usage, 3 the sandbox could not be entered; for
// the act "settings" only if what was set before says that the process dies with its parent and
// cannot be traced.
#include "app/isolation/sandbox/sandbox.h"
#include "tests/app/isolation/sandbox/acts.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <pthread.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr std::string_view without = "without:";

/// From here on the kernel refuses the call as if it did not know it.
bool refuse_call(const std::string& call) {
    const std::size_t slash = call.find('/');
    const int number = seccomp_syscall_resolve_name(call.substr(0, slash).c_str());
    scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
    const std::uint32_t refused = SCMP_ACT_ERRNO(ENOSYS);
    const bool has_argument = slash != std::string::npos;
    const unsigned long first = has_argument ? std::stoul(call.substr(slash + 1)) : 0;
    const int error =
        has_argument ? seccomp_rule_add(filter, refused, number, 1, SCMP_A0_32(SCMP_CMP_EQ, first))
                     : seccomp_rule_add(filter, refused, number, 0);
    return error == 0 && seccomp_load(filter) == 0;
}

Result<void> enter(const std::string& steps, WorkerKind kind) {
    if (steps.starts_with(without) && !refuse_call(steps.substr(without.size()))) _exit(2);
    if (steps == "all" || steps.starts_with(without)) return enter_sandbox(kind);
    if (steps == "files") return deny_files(kind);
    if (steps == "system") return allow_only_reading_the_system();
    if (steps == "calls") return filter_calls(kind);
    return {};
}

[[noreturn]] void spin() {
    for (volatile bool goes_on = true; goes_on;) {
    }
    _exit(0);
}

/// Allocates and writes gigabytes.
int allocate() {
    constexpr std::size_t block = std::size_t{64} << 20U;
    std::vector<std::vector<char>> blocks;
    for (int i = 0; i < 64; ++i) blocks.emplace_back(block, 'x');
    return 0;
}

void* wait_for_ever(void* /*unused*/) {
    for (std::atomic<int> never = 0;;) never.wait(0);
}

/// Starts as many threads as it can, at most 3000, each with the smallest stack; writes how many.
int start_threads() {
    constexpr int wanted = 3000;
    pthread_attr_t small;
    pthread_attr_init(&small);
    pthread_attr_setstacksize(&small, std::size_t{16} << 10U);
    int count = 0;
    for (pthread_t one{}; count < wanted; ++count)
        if (pthread_create(&one, &small, wait_for_ever, nullptr) != 0) break;
    return write(worker_output, &count, sizeof count) == sizeof count ? 0 : 1;
}

int write_much() {
    const std::vector<char> block(std::size_t{1} << 20U, 'x');
    for (int i = 0; i < 1024; ++i)
        if (write(worker_output, block.data(), block.size()) < 0) return 1;
    return 0;
}

/// Returns true if the steps before made the process untraceable and let it die with its parent.
bool is_shut_off() {
    int death = 0;
    return prctl(PR_GET_DUMPABLE) == 0 && prctl(PR_GET_PDEATHSIG, &death) == 0 && death == SIGKILL;
}

/// A thread that a library started before the process enters the sandbox.
class EarlierThread {
  public:
    EarlierThread()
        : thread_([this] {
              may_act_.wait(false);
              has_socket_ = socket(AF_UNIX, SOCK_STREAM, 0) >= 0;
          }) {}

    bool opens_socket() {
        may_act_ = true;
        may_act_.notify_one();
        thread_.join();
        return has_socket_;
    }

  private:
    std::atomic<bool> may_act_ = false;
    bool has_socket_ = false;
    std::thread thread_;
};

int try_act(const std::string& name) {
    if (name == "spin") spin();
    if (name == "allocate") return allocate();
    if (name == "write much") return write_much();
    if (name == "threads") return start_threads();
    if (name == "nothing") return 0;
    if (name == "read system file") return read_system_file() >= 0 ? 0 : 1;
    for (const Act& act : acts())
        if (act.name == name) return act.run() >= 0 ? 0 : 1;
    return 2;
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    using namespace touchline;
    if (argc != 4) return 2;
    const std::string act = argv[3];
    std::optional<EarlierThread> thread;
    if (act == "thread") thread.emplace();
    const auto entered = enter(argv[1], static_cast<WorkerKind>(std::atoi(argv[2])));
    if (!entered) {
        std::fprintf(stderr, "%s\n", entered.error().line.c_str());
        return act == "settings" && !is_shut_off() ? 0 : 3;
    }
    if (thread) _exit(thread->opens_socket() ? 0 : 1);
    _exit(try_act(act));
}
