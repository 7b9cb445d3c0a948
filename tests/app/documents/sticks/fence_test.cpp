// Tries everything that a captured import might try, from inside the sandbox.
#include "app/documents/sticks/stick_reading.h"
#include "app/isolation/sandbox/sandbox.h"
#include "tests/app/documents/sticks/stick_folder.h"
#include "tests/app/isolation/sandbox/acts.h"

#include <array>
#include <csignal>
#include <functional>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/openat2.h>
#include <sys/syscall.h>
#include <sys/wait.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

enum class Outcome : std::uint8_t { worked, was_refused, was_killed, not_shut_in, other };

class Fence : public testing::Test {
  protected:
    Fence() {
        stick.file("a.png", "whole");
        elsewhere.file("victim", "whole");
        fs::current_path(elsewhere.path());
    }

    ~Fence() override { fs::current_path("/"); }

    /// Runs the act in a sandboxed child process. It worked if it returned 0 or more, and was
    /// killed if it died of `deadly`.
    Outcome try_inside(const std::function<long(const Descriptor& root)>& act,
                       int deadly = SIGSYS) {
        const pid_t pid = fork();
        if (pid == 0) {
            const Descriptor root = stick.open();
            if (!shut_in(root, 1 << 20)) _exit(3);
            _exit(act(root) >= 0 ? 0 : 1);
        }
        int status = 0;
        waitpid(pid, &status, 0);
        if (WIFSIGNALED(status))
            return WTERMSIG(status) == deadly ? Outcome::was_killed : Outcome::other;
        switch (WEXITSTATUS(status)) {
            case 0:
                return Outcome::worked;
            case 1:
                return Outcome::was_refused;
            case 3:
                return Outcome::not_shut_in;
            default:
                return Outcome::other;
        }
    }

    StickFolder stick;
    StickFolder elsewhere;
};

/// Opens without any of the guarantees that open_beneath() asks for.
long open_anyhow(int folder, const char* name, int flags) {
    open_how how{};
    how.flags = static_cast<unsigned>(flags);
    how.mode = (flags & O_CREAT) != 0 ? 0600 : 0;
    return syscall(SYS_openat2, folder, name, &how, sizeof(how));
}

TEST_F(Fence, LetsTheStickBeRead) {
    EXPECT_EQ(try_inside([](const Descriptor& root) -> long {
                  const Descriptor file = open_beneath(root, "a.png", 0);
                  char byte = 0;
                  return file.is_open() && read(file.number(), &byte, 1) == 1 && byte == 'w' ? 0
                                                                                             : -1;
              }),
              Outcome::worked);
}

TEST_F(Fence, LetsTheStickBeListed) {
    EXPECT_EQ(try_inside([](const Descriptor& root) -> long {
                  const Descriptor folder(
                      static_cast<int>(open_anyhow(root.number(), ".", O_RDONLY | O_DIRECTORY)));
                  std::array<char, 1024> entries{};
                  return folder.is_open() && syscall(SYS_getdents64, folder.number(),
                                                     entries.data(), entries.size()) > 0
                             ? 0
                             : -1;
              }),
              Outcome::worked);
}

TEST_F(Fence, EveryActOfACapturedWorkerIsDenied) {
    for (const Act& act : acts()) {
        const Outcome outcome =
            try_inside([&act](const Descriptor&) { return act.run(); }, deadly_signal(act));
        EXPECT_TRUE(outcome == Outcome::was_killed || outcome == Outcome::was_refused)
            << act.name << ' ' << static_cast<int>(outcome);
        EXPECT_EQ(fs::file_size("victim"), 5U) << act.name;
        EXPECT_FALSE(fs::exists("must-not-exist")) << act.name;
    }
}

TEST_F(Fence, TheOneCallThatOpensLeadsNowhereElse) {
    const auto refused = [this](const char* name, int flags) {
        return try_inside([name, flags](const Descriptor&) {
                   return open_anyhow(AT_FDCWD, name, flags);
               }) == Outcome::was_refused;
    };
    EXPECT_TRUE(refused("/etc/passwd", O_RDONLY));
    EXPECT_TRUE(refused("/proc/self/mem", O_RDWR));
    EXPECT_TRUE(refused("/", O_RDONLY | O_DIRECTORY));
    EXPECT_TRUE(refused("victim", O_WRONLY));
    EXPECT_TRUE(refused("must-not-exist", O_CREAT | O_WRONLY));
    // Otherwise the lines above would prove nothing.
    EXPECT_GE(Descriptor(static_cast<int>(open_anyhow(AT_FDCWD, "/etc/passwd", O_RDONLY))).number(),
              0);
}

TEST_F(Fence, NothingOnTheStickIsWritten) {
    const auto refused = [this](const char* name, int flags) {
        return try_inside([name, flags](const Descriptor& root) {
                   return open_anyhow(root.number(), name, flags);
               }) == Outcome::was_refused;
    };
    EXPECT_TRUE(refused("a.png", O_WRONLY));
    EXPECT_TRUE(refused("a.png", O_RDWR));
    EXPECT_TRUE(refused("new.png", O_CREAT | O_WRONLY));
    EXPECT_EQ(fs::file_size(stick.path() / "a.png"), 5U);
    EXPECT_FALSE(fs::exists(stick.path() / "new.png"));
}

TEST_F(Fence, TheOutputHasAnEnd) {
    const Descriptor output(::open("output", O_CREAT | O_RDWR | O_CLOEXEC, 0600));
    EXPECT_EQ(try_inside([&output](const Descriptor&) -> long {
                  const std::vector<std::byte> block(2U << 20U);
                  return write_all(output, block) ? 0 : -1;
              }),
              Outcome::other);  // SIGXFSZ
    EXPECT_LE(fs::file_size("output"), std::uintmax_t{1} << 20U);
}

}  // namespace
}  // namespace touchline
