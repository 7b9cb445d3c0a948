// Tries everything that a captured worker might try, from inside the sandbox.
#include "app/isolation/sandbox/sandbox.h"

#include "tests/app/isolation/sandbox/acts.h"
#include "tests/app/signal_one.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

/// How the probe ended.
struct Ending {
    int status = -1;  // exit status; -1: by a signal
    int signal = 0;

    friend bool operator==(const Ending&, const Ending&) = default;
};

constexpr Ending worked{0, 0};
constexpr Ending was_refused{1, 0};
constexpr Ending was_killed{-1, SIGSYS};  // by the call filter
constexpr Ending was_not_shut_in{3, 0};

Ending killed_for(const Act& act) {
    return {-1, deadly_signal(act)};
}

/// The probe lies beside this program.
fs::path probe_program() {
    return fs::read_symlink("/proc/self/exe").parent_path() / "sandbox_probe";
}

constexpr uid_t id_of_nobody = 65534;

/// The user that the probe runs as: a test may run as root, whom no process limit binds.
enum class As : std::uint8_t { we_are, nobody };

/// Starts the probe and returns its process; the output goes to `memory`.
pid_t start_probe(const std::string& steps, WorkerKind kind, std::string_view act, int memory,
                  As who = As::we_are) {
    const std::string kind_text = std::to_string(static_cast<int>(kind));
    const std::string act_text(act);
    const std::string program = probe_program().string();
    const pid_t pid = fork();
    if (pid != 0) return pid;
    dup2(memory, worker_input);
    dup2(memory, worker_output);
    if (who == As::nobody && geteuid() == 0 &&
        (setgid(id_of_nobody) != 0 || setuid(id_of_nobody) != 0))
        _exit(126);
    execl(program.c_str(), "probe", steps.c_str(), kind_text.c_str(), act_text.c_str(), nullptr);
    _exit(127);
}

Ending probe(const std::string& steps, WorkerKind kind, std::string_view act) {
    const int memory = memfd_create("probe", 0);
    const pid_t pid = start_probe(steps, kind, act, memory);
    close(memory);
    int status = 0;
    waitpid(pid, &status, 0);
    if (WIFSIGNALED(status)) return {-1, WTERMSIG(status)};
    return {WEXITSTATUS(status), 0};
}

class SandboxAlone : public testing::Test {
  protected:
    SandboxAlone() {
        const fs::path folder =
            fs::temp_directory_path() / ("touchline-sandbox-" + std::to_string(getpid()));
        fs::create_directories(folder);
        fs::current_path(folder);  // the probe's too
        std::ofstream("victim") << "whole";
    }

    ~SandboxAlone() override {
        const fs::path folder = fs::current_path();
        fs::current_path(folder.parent_path());
        fs::remove_all(folder);
    }
};

class Sandbox : public SandboxAlone, public testing::WithParamInterface<WorkerKind> {};

TEST_P(Sandbox, LetsAWorkerThatTriesNothingLive) {
    EXPECT_EQ(probe("all", GetParam(), "nothing"), worked);
}

TEST_P(Sandbox, EveryActIsDenied) {
    int denied = 0;
    for (const Act& act : acts()) {
        const Ending ending = probe("all", GetParam(), act.name);
        const bool is_denied = ending == killed_for(act) || ending == was_refused;
        denied += is_denied ? 1 : 0;
        EXPECT_TRUE(is_denied) << act.name << ": " << ending.status << ' ' << ending.signal;
        EXPECT_EQ(fs::file_size("victim"), 5U) << act.name;
        EXPECT_FALSE(fs::exists("must-not-exist")) << act.name;
    }
    RecordProperty("tried", static_cast<int>(acts().size()));
    RecordProperty("denied", denied);
}

TEST_P(Sandbox, TheFilterOfCallsAloneDeniesEveryAct) {
    for (const Act& act : acts()) {
        if (act.is_reading && limits_of(GetParam()).reads_fonts) continue;
        const Ending ending = probe("calls", GetParam(), act.name);
        EXPECT_TRUE(ending == killed_for(act) || ending == was_refused) << act.name;
    }
}

TEST_P(Sandbox, LandlockAloneDeniesEveryActOnFiles) {
    for (const Act& act : acts()) {
        if (!act.is_of_files) continue;
        EXPECT_EQ(probe("files", GetParam(), act.name), was_refused) << act.name;
    }
    EXPECT_EQ(probe("files", GetParam(), "read system file"), was_refused);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Sandbox,
                         testing::Values(WorkerKind::raster, WorkerKind::heif, WorkerKind::document,
                                         WorkerKind::ocr, WorkerKind::speech, WorkerKind::pack,
                                         WorkerKind::trace, WorkerKind::figure));

TEST_F(SandboxAlone, WhileLibrariesArePreparedOnlyTheSystemIsRead) {
    for (const Act& act : acts()) {
        if (!act.is_of_files || act.name == "exec") continue;
        EXPECT_EQ(probe("system", WorkerKind::document, act.name), was_refused) << act.name;
    }
    EXPECT_EQ(probe("system", WorkerKind::document, "read system file"), worked);
}

/// Tries a kernel that lacks each step in turn. A worker outside the sandbox does no work.
TEST_F(SandboxAlone, IsNotEnteredWhereAnyStepFails) {
    const std::string prctl = "without:prctl/";
    for (const std::string& steps :
         {prctl + std::to_string(PR_SET_PDEATHSIG), prctl + std::to_string(PR_SET_DUMPABLE),
          prctl + std::to_string(PR_SET_NO_NEW_PRIVS), std::string("without:close_range"),
          std::string("without:prlimit64"), std::string("without:landlock_create_ruleset"),
          std::string("without:landlock_add_rule"), std::string("without:landlock_restrict_self"),
          std::string("without:openat"), std::string("without:seccomp")}) {
        EXPECT_EQ(probe(steps, WorkerKind::document, "nothing"), was_not_shut_in) << steps;
    }
}

/// The last step is made to fail, because inside the sandbox nobody could ask.
TEST_F(SandboxAlone, DiesWithItsParentAndCannotBeTraced) {
    EXPECT_EQ(probe("without:seccomp", WorkerKind::raster, "settings"), was_not_shut_in);
}

TEST_F(SandboxAlone, TheFilterOfCallsHoldsForThreadsStartedBefore) {
    EXPECT_EQ(probe("calls", WorkerKind::heif, "thread"), was_killed);
    EXPECT_EQ(probe("none", WorkerKind::heif, "thread"), worked);
}

/// Otherwise the tests above would prove nothing.
TEST_F(SandboxAlone, WithoutItTheActsWork) {
    for (const char* act : {"open", "openat", "stat", "socket", "unix socket", "fork",
                            "memory with code", "data made code", "memfd", "duplicate"}) {
        EXPECT_EQ(probe("none", WorkerKind::raster, act), worked) << act;
    }
}

TEST_F(SandboxAlone, MemoryHasAnEnd) {
    EXPECT_EQ(probe("all", WorkerKind::raster, "allocate"), (Ending{70, 0}));
}

/// Returns how many of 3000 threads it got.
int threads_started(const std::string& steps, WorkerKind kind) {
    const int memory = memfd_create("probe", 0);
    const pid_t pid = start_probe(steps, kind, "threads", memory, As::nobody);
    int status = 0;
    waitpid(pid, &status, 0);
    EXPECT_EQ(status, 0);
    int count = -1;
    EXPECT_EQ(pread(memory, &count, sizeof count, 0), static_cast<ssize_t>(sizeof count));
    close(memory);
    return count;
}

TEST_F(SandboxAlone, ThreadsHaveAnEnd) {
    for (const WorkerKind kind : {WorkerKind::heif, WorkerKind::document, WorkerKind::trace}) {
        const int count = threads_started("all", kind);
        EXPECT_GE(count, 48) << "a codec needs some";
        EXPECT_LE(count, static_cast<int>(most_worker_threads) + 8);
        EXPECT_EQ(threads_started("calls", kind), 3000) << "without the limit it gets all";
        RecordProperty("threads", count);
    }
}

/// When memory is short, the kernel kills the worker first.
TEST_F(SandboxAlone, GoesBeforeAllOthersWhenMemoryIsShort) {
    for (const WorkerKind kind : {WorkerKind::raster, WorkerKind::heif, WorkerKind::document,
                                  WorkerKind::ocr, WorkerKind::speech, WorkerKind::pack}) {
        const int memory = memfd_create("probe", 0);
        const pid_t pid = start_probe("all", kind, "spin", memory);
        close(memory);
        const std::string file = "/proc/" + std::to_string(pid) + "/oom_score_adj";
        int score = 0;
        for (int i = 0; i < 10'000 && score != 1000; ++i) {
            std::ifstream(file) >> score;
            usleep(1000);
        }
        EXPECT_EQ(score, 1000) << static_cast<int>(kind);
        signal_one(pid, SIGKILL);
        waitpid(pid, nullptr, 0);
    }
}

TEST_F(SandboxAlone, TheOutputHasAnEnd) {
    EXPECT_EQ(probe("all", WorkerKind::raster, "write much"), (Ending{-1, SIGXFSZ}));
}

TEST_F(SandboxAlone, ProcessorTimeHasAnEnd) {
    EXPECT_EQ(probe("all", WorkerKind::raster, "spin"), (Ending{-1, SIGXCPU}));
}

}  // namespace
}  // namespace touchline
