// Tests how the parent handles each way in which a worker ends. The worker is a shell;
// tests/app/documents/decode has the liars.
#include "app/isolation/sandbox/worker.h"

#include "app/isolation/process/child.h"
#include "app/isolation/process/memory.h"
#include "app/isolation/sandbox/sandbox.h"

#include <algorithm>
#include <csignal>
#include <ctime>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchline {
namespace {

Result<Descriptor, WorkerEnd> worked(const std::string& script,
                                     WorkerKind kind = WorkerKind::raster) {
    const std::string text = "hello\n";
    const Descriptor input = sealed_copy(std::as_bytes(std::span(text))).value();
    return run_worker({"/bin/sh", {"-c", script}, kind}, input);
}

std::string text_of(const Result<Descriptor, WorkerEnd>& answer) {
    const auto mapping = map_sealed(answer.value(), 1U << 20U);
    if (!mapping) return mapping.error().line;
    const auto bytes = mapping->bytes();
    std::string text(bytes.size(), '\0');
    std::ranges::transform(bytes, text.begin(), [](std::byte b) { return static_cast<char>(b); });
    return text;
}

bool has_a_child() {
    return waitpid(-1, nullptr, WNOHANG) >= 0;
}

TEST(Worker, ReadsItsInputAndItsOutputIsSealed) {
    const auto answer = worked("cat /proc/self/fd/3 >&4");
    EXPECT_EQ(text_of(answer), "hello\n");
    EXPECT_LT(write(answer->number(), "x", 1), 0);
}

/// Both sides number the descriptors alike.
TEST(Worker, FindsItsDescriptorsWhereTheyAreHanded) {
    EXPECT_EQ(worker_input, Child::first_handed);
    EXPECT_EQ(worker_output, Child::first_handed + 1);
    EXPECT_EQ(worker_descriptors, Child::first_handed + 2);
}

TEST(Worker, HasOneThreadOfOpenMP) {
    EXPECT_EQ(text_of(worked("printf %s \"$OMP_THREAD_LIMIT\" >&4")), "1");
}

struct Ending {
    const char* script;
    WorkerEnd end;
};

class Endings : public testing::TestWithParam<Ending> {};

TEST_P(Endings, AreToldAndNothingOfTheWorkerIsKept) {
    const auto answer = worked(GetParam().script);
    ASSERT_FALSE(answer.has_value());
    EXPECT_EQ(answer.error(), GetParam().end) << GetParam().script;
    EXPECT_FALSE(has_a_child());
}

// A shell that ends itself by a signal names its own process.
INSTANTIATE_TEST_SUITE_P(
    All, Endings,
    testing::Values(Ending{"exit 0", WorkerEnd::no_answer},
                    Ending{"echo much >&4; exit 69", WorkerEnd::not_started},
                    Ending{"echo much >&4; exit 70", WorkerEnd::out_of_memory},
                    Ending{"echo much >&4; exit 1", WorkerEnd::crashed},
                    Ending{"echo much >&4; exit 68", WorkerEnd::crashed},
                    Ending{"echo much >&4; kill -SEGV $$", WorkerEnd::crashed},
                    Ending{"echo much >&4; kill -SYS $$", WorkerEnd::crashed},
                    Ending{"echo much >&4; kill -KILL $$", WorkerEnd::out_of_memory},
                    Ending{"echo much >&4; kill -XCPU $$", WorkerEnd::out_of_time}));

TEST(Worker, AProgramThatIsMissingIsNotStarted) {
    const Descriptor input = sealed_copy(std::as_bytes(std::span("x"))).value();
    EXPECT_EQ(run_worker({"/nowhere/at-all", {}, WorkerKind::raster}, input).error(),
              WorkerEnd::not_started);
}

/// The deadline is wall-clock time, 6 s for this kind, and no sooner on a busy machine.
TEST(Worker, ThatSleepsIsEndedAtItsDeadline) {
    timespec begin{};
    timespec end{};
    clock_gettime(CLOCK_MONOTONIC, &begin);
    const auto answer = worked("echo much >&4; exec sleep 600");
    clock_gettime(CLOCK_MONOTONIC, &end);
    ASSERT_FALSE(answer.has_value());
    EXPECT_EQ(answer.error(), WorkerEnd::out_of_time);
    EXPECT_FALSE(has_a_child());
    EXPECT_GE(end.tv_sec - begin.tv_sec, 5);
}

/// A voice may speak as long as somebody listens.
TEST(Worker, ThatSpeaksHasNoDeadline) {
    EXPECT_EQ(text_of(worked("sleep 0.2; echo spoken >&4", WorkerKind::speech)), "spoken\n");
}

/// A timer or a profiler may interrupt the wait; it then goes on.
TEST(Worker, IsWaitedForThroughSignals) {
    struct sigaction nothing {};

    nothing.sa_handler = [](int) {};
    sigaction(SIGALRM, &nothing, nullptr);
    const itimerval often{{0, 20'000}, {0, 20'000}};
    const itimerval never{};
    setitimer(ITIMER_REAL, &often, nullptr);
    const std::string text = text_of(worked("sleep 0.2; echo spoken >&4"));
    setitimer(ITIMER_REAL, &never, nullptr);
    EXPECT_EQ(text, "spoken\n");
}

/// Takes every descriptor that this process may have.
TEST(Worker, IsNotStartedWhereNothingIsLeftForItsAnswer) {
    const Descriptor input = sealed_copy(std::as_bytes(std::span("x"))).value();
    std::vector<Descriptor> all;
    do all.emplace_back(::dup(input.number()));
    while (all.back().is_open());
    EXPECT_EQ(run_worker({"/bin/true", {}, WorkerKind::raster}, input).error(),
              WorkerEnd::out_of_memory);
}

}  // namespace
}  // namespace touchline
