// Tests what each kind of worker may do by asking the rules themselves; sandbox_test.cpp asks the
// kernel.
#include "app/isolation/sandbox/policy.h"

#include "app/isolation/sandbox/sandbox.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>

namespace touchline {
namespace {

using Arguments = std::array<std::uint64_t, 6>;

constexpr std::array all_kinds{WorkerKind::raster, WorkerKind::heif,   WorkerKind::document,
                               WorkerKind::ocr,    WorkerKind::speech, WorkerKind::pack,
                               WorkerKind::trace,  WorkerKind::figure};

const std::string killed = "killed";
const std::string allowed = "allowed";

std::string refused(int error) {
    return "refused " + std::to_string(error);
}

bool holds(const CallRule& rule, int call, const Arguments& arguments) {
    if (rule.call != call) return false;
    return !rule.where ||
           (arguments.at(rule.where->argument) & rule.where->mask) == rule.where->value;
}

/// Returns what the filter answers; it must never be a contradiction.
std::string answer(const std::vector<CallRule>& rules, int call, const Arguments& arguments = {}) {
    std::set<std::string> answers;
    for (const CallRule& rule : rules)
        if (holds(rule, call, arguments))
            answers.insert(rule.answer == CallAnswer::allowed ? allowed : refused(rule.error));
    if (answers.empty()) return killed;
    return answers.size() == 1 ? *answers.begin() : "contradiction";
}

std::vector<CallRule> rules_of(WorkerKind kind) {
    return call_rules(limits_of(kind));
}

Arguments opened_with(int flags) {
    return {0, 0, static_cast<std::uint64_t>(flags), 0, 0, 0};
}

std::set<int> calls_of(const std::vector<CallRule>& rules, CallAnswer answer, bool has_condition) {
    std::set<int> calls;
    for (const CallRule& rule : rules)
        if (rule.answer == answer && rule.where.has_value() == has_condition)
            calls.insert(rule.call);
    return calls;
}

const std::set<int> plain{SCMP_SYS(read),
                          SCMP_SYS(pread64),
                          SCMP_SYS(readv),
                          SCMP_SYS(write),
                          SCMP_SYS(pwrite64),
                          SCMP_SYS(writev),
                          SCMP_SYS(lseek),
                          SCMP_SYS(ftruncate),
                          SCMP_SYS(close),
                          SCMP_SYS(fstat),
                          SCMP_SYS(brk),
                          SCMP_SYS(munmap),
                          SCMP_SYS(mremap),
                          SCMP_SYS(madvise),
                          SCMP_SYS(futex),
                          SCMP_SYS(exit),
                          SCMP_SYS(exit_group),
                          SCMP_SYS(rt_sigreturn),
                          SCMP_SYS(getrandom),
                          SCMP_SYS(gettimeofday),
                          SCMP_SYS(clock_gettime),
                          SCMP_SYS(sched_yield),
                          SCMP_SYS(rt_sigprocmask),
                          SCMP_SYS(sched_getaffinity)};

std::set<int> united(std::set<int> calls, std::initializer_list<int> more) {
    calls.insert(more);
    return calls;
}

TEST(SandboxPolicy, CallsThatAreAllowedWhateverTheirArguments) {
    for (const WorkerKind kind : all_kinds) {
        const std::set<int> expected =
            limits_of(kind).has_threads ? united(plain, {SCMP_SYS(set_robust_list), SCMP_SYS(rseq)})
                                        : plain;
        EXPECT_EQ(calls_of(rules_of(kind), CallAnswer::allowed, false), expected)
            << static_cast<int>(kind);
        RecordProperty(
            "allowed_" + std::to_string(static_cast<int>(kind)),
            static_cast<int>(calls_of(rules_of(kind), CallAnswer::allowed, false).size() +
                             calls_of(rules_of(kind), CallAnswer::allowed, true).size()));
    }
}

TEST(SandboxPolicy, CallsThatAreAllowedForSomeArguments) {
    for (const WorkerKind kind : all_kinds) {
        std::set<int> expected{SCMP_SYS(newfstatat), SCMP_SYS(mmap), SCMP_SYS(mprotect)};
        if (limits_of(kind).has_threads) expected.insert(SCMP_SYS(clone));
        if (limits_of(kind).reads_fonts) expected.insert({SCMP_SYS(openat), SCMP_SYS(fcntl)});
        EXPECT_EQ(calls_of(rules_of(kind), CallAnswer::allowed, true), expected);
    }
}

TEST(SandboxPolicy, WhatLibrariesTryIsRefusedAndDoesNotKill) {
    for (const WorkerKind kind : all_kinds) {
        const auto rules = rules_of(kind);
        for (const int call :
             {SCMP_SYS(readlink), SCMP_SYS(readlinkat), SCMP_SYS(statx), SCMP_SYS(statfs),
              SCMP_SYS(getcwd), SCMP_SYS(getdents64), SCMP_SYS(sysinfo)})
            EXPECT_EQ(answer(rules, call), refused(EACCES)) << call;
        for (const int call : {SCMP_SYS(access), SCMP_SYS(faccessat)})
            EXPECT_EQ(answer(rules, call), refused(0)) << call;
    }
}

TEST(SandboxPolicy, EveryOtherCallKills) {
    std::set<int> named;
    for (const WorkerKind kind : all_kinds)
        for (const CallRule& rule : rules_of(kind)) named.insert(rule.call);
    for (int call = 0; call < 600; ++call) {
        if (named.contains(call)) continue;
        for (const WorkerKind kind : all_kinds) EXPECT_EQ(answer(rules_of(kind), call), killed);
    }
    for (const int call :
         {SCMP_SYS(open), SCMP_SYS(openat2), SCMP_SYS(execve), SCMP_SYS(execveat), SCMP_SYS(fork),
          SCMP_SYS(vfork), SCMP_SYS(socket), SCMP_SYS(connect), SCMP_SYS(kill), SCMP_SYS(tgkill),
          SCMP_SYS(ptrace), SCMP_SYS(ioctl), SCMP_SYS(memfd_create), SCMP_SYS(bpf),
          SCMP_SYS(truncate), SCMP_SYS(unlink), SCMP_SYS(rename), SCMP_SYS(prlimit64)})
        EXPECT_FALSE(named.contains(call)) << call;
}

TEST(SandboxPolicy, MemoryIsNeverMadeExecutable) {
    for (const WorkerKind kind : all_kinds) {
        for (const int call : {SCMP_SYS(mmap), SCMP_SYS(mprotect)}) {
            for (std::uint64_t bits = 0; bits < 8; ++bits)
                EXPECT_EQ(answer(rules_of(kind), call, {0, 0, bits, 0, 0, 0}),
                          (bits & PROT_EXEC) != 0 ? killed : allowed);
        }
    }
}

TEST(SandboxPolicy, ADescriptorIsLookedAtAndAPathIsNot) {
    for (const WorkerKind kind : all_kinds) {
        const auto rules = rules_of(kind);
        EXPECT_EQ(answer(rules, SCMP_SYS(newfstatat), {0, 0, 0, AT_EMPTY_PATH, 0, 0}), allowed);
        EXPECT_EQ(answer(rules, SCMP_SYS(newfstatat), {0, 0, 0, 0, 0, 0}), refused(EACCES));
        EXPECT_EQ(answer(rules, SCMP_SYS(newfstatat), {0, 0, 0, AT_SYMLINK_NOFOLLOW, 0, 0}),
                  refused(EACCES));
    }
}

TEST(SandboxPolicy, ThreadsOnlyWhereACodecNeedsThemAndNeverAProcess) {
    constexpr std::uint64_t thread = CLONE_THREAD | CLONE_VM | CLONE_FS | CLONE_SIGHAND;
    for (const WorkerKind kind : all_kinds) {
        const bool has_threads = limits_of(kind).has_threads;
        const auto rules = rules_of(kind);
        EXPECT_EQ(answer(rules, SCMP_SYS(clone3)), refused(has_threads ? ENOSYS : EAGAIN));
        EXPECT_EQ(answer(rules, SCMP_SYS(clone), {thread}), has_threads ? allowed : killed);
        EXPECT_EQ(answer(rules, SCMP_SYS(clone), {CLONE_VM}), killed);
        EXPECT_EQ(answer(rules, SCMP_SYS(clone), {CLONE_THREAD}), killed);
        EXPECT_EQ(answer(rules, SCMP_SYS(clone), {SIGCHLD}), killed);
        EXPECT_EQ(answer(rules, SCMP_SYS(rt_sigaction)), has_threads ? refused(EPERM) : killed);
        EXPECT_EQ(answer(rules, SCMP_SYS(prctl), {PR_SET_NAME}), has_threads ? refused(0) : killed);
        for (const std::uint64_t what :
             {std::uint64_t{PR_SET_DUMPABLE}, std::uint64_t{PR_SET_SECCOMP}, std::uint64_t{0},
              (std::uint64_t{1} << 32U) + PR_SET_NAME})
            EXPECT_EQ(answer(rules, SCMP_SYS(prctl), {what}), killed) << what;
    }
}

/// Tries every combination of what an opening can ask for.
TEST(SandboxPolicy, FilesAreOpenedForReadingOnlyAndOnlyWhereDocumentsAreDrawn) {
    constexpr std::array changes{O_WRONLY, O_RDWR, O_CREAT, O_TRUNC, O_APPEND, O_PATH, 0x400000};
    for (const WorkerKind kind : all_kinds) {
        const auto rules = rules_of(kind);
        for (unsigned bits = 0; bits < (1U << changes.size()); ++bits) {
            int flags = O_CLOEXEC | O_DIRECTORY;
            for (std::size_t i = 0; i < changes.size(); ++i)
                if ((bits >> i & 1U) != 0) flags |= changes[i];
            const std::string told = answer(rules, SCMP_SYS(openat), opened_with(flags));
            const bool writes = (flags & (O_WRONLY | O_RDWR | O_CREAT)) != 0;
            if (!limits_of(kind).reads_fonts || writes)
                EXPECT_EQ(told, refused(EACCES)) << flags;
            else
                EXPECT_EQ(told, bits == 0 ? allowed : killed) << flags;
        }
        EXPECT_EQ(answer(rules, SCMP_SYS(openat), opened_with(O_RDONLY)),
                  limits_of(kind).reads_fonts ? allowed : refused(EACCES));
        for (const std::uint64_t asked : std::array<std::uint64_t, 2>{F_SETFD, F_GETFL})
            EXPECT_EQ(answer(rules, SCMP_SYS(fcntl), {0, asked}),
                      limits_of(kind).reads_fonts ? allowed : killed);
        EXPECT_EQ(answer(rules, SCMP_SYS(fcntl), {0, F_SETFL}), killed);
    }
}

TEST(SandboxPolicy, WhoReadsBeneathAFolderHasTheseCallsAndNoOthers) {
    const auto rules = call_rules_of_reading_beneath();
    const std::set<int> expected{
        SCMP_SYS(openat2),      SCMP_SYS(getdents64), SCMP_SYS(read),         SCMP_SYS(write),
        SCMP_SYS(close),        SCMP_SYS(lseek),      SCMP_SYS(fstat),        SCMP_SYS(brk),
        SCMP_SYS(munmap),       SCMP_SYS(mremap),     SCMP_SYS(madvise),      SCMP_SYS(futex),
        SCMP_SYS(exit),         SCMP_SYS(exit_group), SCMP_SYS(rt_sigreturn), SCMP_SYS(getrandom),
        SCMP_SYS(clock_gettime)};
    EXPECT_EQ(calls_of(rules, CallAnswer::allowed, false), expected);
    EXPECT_EQ(calls_of(rules, CallAnswer::allowed, true),
              (std::set<int>{SCMP_SYS(newfstatat), SCMP_SYS(mmap), SCMP_SYS(mprotect)}));
    EXPECT_TRUE(calls_of(rules, CallAnswer::refused, false).empty());
    EXPECT_TRUE(calls_of(rules, CallAnswer::refused, true).empty());
    EXPECT_EQ(answer(rules, SCMP_SYS(newfstatat)), killed);
    EXPECT_EQ(answer(rules, SCMP_SYS(mmap), {0, 0, PROT_EXEC}), killed);
    EXPECT_EQ(answer(rules, SCMP_SYS(mprotect), {0, 0, PROT_EXEC | PROT_READ}), killed);
}

std::vector<std::string> texts(std::span<const char* const> folders) {
    return {folders.begin(), folders.end()};
}

TEST(SandboxPolicy, FoldersThatAreRead) {
    EXPECT_EQ(texts(folders_of_the_system()),
              (std::vector<std::string>{"/usr", "/lib", "/etc/fonts", "/etc/ld.so.cache",
                                        "/var/cache/fontconfig"}));
    for (const WorkerKind kind : all_kinds) {
        const auto folders = texts(folders_of_work(limits_of(kind)));
        if (kind == WorkerKind::document)
            EXPECT_EQ(folders,
                      (std::vector<std::string>{"/usr/share/fonts", "/usr/local/share/fonts",
                                                "/usr/share/poppler"}));
        else
            EXPECT_TRUE(folders.empty());
    }
}

/// Returns the soft and the hard limit; empty if there is none.
std::vector<std::uint64_t> limit_of(const std::vector<ResourceLimit>& limits, int what) {
    std::vector<std::uint64_t> found;
    for (const ResourceLimit& limit : limits)
        if (limit.what == what) found.insert(found.end(), {limit.soft, limit.hard});
    return found;
}

using Pair = std::vector<std::uint64_t>;

TEST(SandboxPolicy, LimitsOfEachResource) {
    for (const WorkerKind kind : all_kinds) {
        const WorkerLimits most = limits_of(kind);
        const auto limits = resource_limits(most, true);
        EXPECT_EQ(limit_of(limits, RLIMIT_AS),
                  (Pair{most.address_space_bytes, most.address_space_bytes}));
        EXPECT_EQ(limit_of(limits, RLIMIT_CPU),
                  most.cpu_s == 0 ? Pair{} : (Pair{most.cpu_s, most.cpu_s + 1U}));
        EXPECT_EQ(limit_of(limits, RLIMIT_FSIZE), (Pair{most.file_bytes, most.file_bytes}));
        EXPECT_EQ(limit_of(limits, RLIMIT_NOFILE), (Pair{8, 8}));
        EXPECT_EQ(limit_of(limits, RLIMIT_CORE), (Pair{0, 0}));
        EXPECT_EQ(limit_of(limits, RLIMIT_NPROC), most.has_threads ? Pair{} : (Pair{0, 0}));
        EXPECT_EQ(limit_of(resource_limits(most, false), RLIMIT_AS),
                  (Pair{RLIM_INFINITY, RLIM_INFINITY}));
        for (const ResourceLimit& limit : limits) EXPECT_STRNE(limit.name, "");
    }
}

/// Tests the table of app/isolation/sandbox/README.md.
TEST(SandboxPolicy, WhatEachKindMayTakeOfTheMachine) {
    constexpr std::size_t MiB = 1024 * 1024;

    struct Row {
        WorkerKind kind;
        std::size_t input_MiB, memory_MiB, cpu_s, output_MiB;
        double deadline_s;
        bool has_threads, reads_fonts;
    };

    constexpr std::array<Row, 8> rows{{{WorkerKind::raster, 200, 1024, 8, 200, 10.0, false, false},
                                       {WorkerKind::heif, 64, 1536, 12, 200, 15.0, true, false},
                                       {WorkerKind::document, 128, 1024, 8, 200, 10.0, true, true},
                                       {WorkerKind::ocr, 200, 1024, 30, 16, 40.0, false, false},
                                       {WorkerKind::speech, 1, 256, 0, 0, 0.0, false, false},
                                       {WorkerKind::pack, 64, 512, 6, 112, 8.0, false, false},
                                       {WorkerKind::trace, 256, 1024, 8, 200, 10.0, true, false},
                                       {WorkerKind::figure, 320, 2048, 60, 16, 60.0, true, false}}};
    static_assert(rows.size() == worker_kind_count);
    for (const Row& row : rows) {
        const WorkerLimits limits = limits_of(row.kind);
        EXPECT_EQ(limits.input_bytes, row.input_MiB * MiB);
        EXPECT_EQ(limits.address_space_bytes, row.memory_MiB * MiB);
        EXPECT_EQ(limits.cpu_s, row.cpu_s);
        EXPECT_EQ(limits.file_bytes, row.output_MiB * MiB);
        EXPECT_EQ(limits.deadline_s, row.deadline_s);
        EXPECT_EQ(limits.has_threads, row.has_threads);
        EXPECT_EQ(limits.reads_fonts, row.reads_fonts);
    }
}

TEST(SandboxPolicy, AKindThatIsNoneMayDoNothing) {
    const WorkerLimits none = limits_of(static_cast<WorkerKind>(worker_kind_count));
    EXPECT_EQ(none.address_space_bytes, 0U);
    EXPECT_EQ(none.input_bytes, 0U);
    EXPECT_EQ(none.file_bytes, 0U);
    EXPECT_FALSE(none.has_threads);
    EXPECT_FALSE(none.reads_fonts);
}

}  // namespace
}  // namespace touchline
