// The calls that a worker may make; any other kills it. What a library merely tries and does
// without (a configuration file, a thread) is refused instead.
#include "app/sandbox/sandbox.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>

#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>

namespace touchline {
namespace {

constexpr std::array plain_calls{SCMP_SYS(read),
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
                                 SCMP_SYS(clock_gettime),
                                 SCMP_SYS(gettimeofday),
                                 SCMP_SYS(sched_yield),
                                 SCMP_SYS(rt_sigprocmask),
                                 SCMP_SYS(sched_getaffinity)};

/// Tried by fontconfig, GLib, libexiv2, iconv and sorting, which then go on without.
constexpr std::array files_of_libraries{SCMP_SYS(readlink),   SCMP_SYS(statx),
                                        SCMP_SYS(statfs),     SCMP_SYS(getcwd),
                                        SCMP_SYS(getdents64), SCMP_SYS(sysinfo)};

/// The flags of openat2 lie in memory, where no filter sees them: Landlock judges those.
constexpr std::array calls_of_reading_beneath{
    SCMP_SYS(openat2),      SCMP_SYS(getdents64), SCMP_SYS(read),         SCMP_SYS(write),
    SCMP_SYS(close),        SCMP_SYS(lseek),      SCMP_SYS(fstat),        SCMP_SYS(brk),
    SCMP_SYS(munmap),       SCMP_SYS(mremap),     SCMP_SYS(madvise),      SCMP_SYS(futex),
    SCMP_SYS(exit),         SCMP_SYS(exit_group), SCMP_SYS(rt_sigreturn), SCMP_SYS(getrandom),
    SCMP_SYS(clock_gettime)};

struct Release {
    void operator()(void* filter) const { seccomp_release(filter); }
};

/// The rules in the making; the first error is kept.
class Filter {
  public:
    Filter() : filter_(seccomp_init(SCMP_ACT_KILL_PROCESS)) {
        if (!filter_) error_ = -ENOMEM;
        // What is no call of this machine kills the process too, not just the thread that makes it.
        if (error_ == 0) {
            error_ =
                seccomp_attr_set(filter_.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
        }
        // For the threads that a library has started while it was prepared, too.
        if (error_ == 0) error_ = seccomp_attr_set(filter_.get(), SCMP_FLTATR_CTL_TSYNC, 1);
    }

    template <class... Conditions>
    void rule(std::uint32_t action, int call, Conditions... conditions) {
        if (error_ == 0)
            error_ =
                seccomp_rule_add(filter_.get(), action, call, sizeof...(conditions), conditions...);
    }

    Result<void> load() {
        if (error_ == 0) error_ = seccomp_load(filter_.get());
        if (error_ == 0) return {};
        return failure(std::string("the sandbox cannot be entered: seccomp: ") +
                       std::strerror(-error_));
    }

  private:
    std::unique_ptr<void, Release> filter_;
    int error_ = 0;
};

/// What this C library makes of fstat(): a descriptor, no path.
void allow_looking_at_descriptors(Filter& filter) {
    filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(newfstatat),
                SCMP_A3(SCMP_CMP_MASKED_EQ, AT_EMPTY_PATH, AT_EMPTY_PATH));
}

void allow_memory_without_code(Filter& filter) {
    const auto not_executable = SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0);
    filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(mmap), not_executable);
    filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(mprotect), not_executable);
}

/// Threads of this process; a new process is none.
void allow_threads(Filter& filter) {
    filter.rule(SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3));  // its flags lie in memory
    filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(clone),
                SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD | CLONE_VM, CLONE_THREAD | CLONE_VM));
    filter.rule(SCMP_ACT_ERRNO(EPERM),
                SCMP_SYS(rt_sigaction));  // of the C library, before the first
    filter.rule(SCMP_ACT_ERRNO(0), SCMP_SYS(prctl), SCMP_A0(SCMP_CMP_EQ, PR_SET_NAME));
    filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(set_robust_list));
    filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(rseq));
}

/// What Landlock leaves to read can be opened for reading; nothing can be opened for writing.
void allow_reading_fonts(Filter& filter) {
    constexpr int changes = O_ACCMODE | O_CREAT | O_TRUNC | O_APPEND | O_PATH | O_TMPFILE;
    filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(openat),
                SCMP_A2(SCMP_CMP_MASKED_EQ, changes & ~O_DIRECTORY, 0));
    filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(fcntl), SCMP_A1(SCMP_CMP_EQ, F_SETFD));
    for (const int change : {O_WRONLY, O_RDWR, O_CREAT})
        filter.rule(SCMP_ACT_ERRNO(EACCES), SCMP_SYS(openat),
                    SCMP_A2(SCMP_CMP_MASKED_EQ, static_cast<scmp_datum_t>(change),
                            static_cast<scmp_datum_t>(change)));
}

void refuse_what_libraries_try(Filter& filter, const WorkerLimits& limits) {
    for (const int call : files_of_libraries) filter.rule(SCMP_ACT_ERRNO(EACCES), call);
    // Asked of every font, also of those that were loaded before: it seems to be there.
    filter.rule(SCMP_ACT_ERRNO(0), SCMP_SYS(access));
    filter.rule(SCMP_ACT_ERRNO(EACCES), SCMP_SYS(newfstatat),
                SCMP_A3(SCMP_CMP_MASKED_EQ, AT_EMPTY_PATH, 0));
    limits.reads_fonts ? allow_reading_fonts(filter)
                       : filter.rule(SCMP_ACT_ERRNO(EACCES), SCMP_SYS(openat));
}

void refuse_threads(Filter& filter) {
    filter.rule(SCMP_ACT_ERRNO(EAGAIN), SCMP_SYS(clone3));
}

}  // namespace

Result<void> filter_calls(WorkerKind kind) {
    Filter filter;
    for (const int call : plain_calls) filter.rule(SCMP_ACT_ALLOW, call);
    allow_looking_at_descriptors(filter);
    allow_memory_without_code(filter);
    const WorkerLimits limits = limits_of(kind);
    refuse_what_libraries_try(filter, limits);
    limits.has_threads ? allow_threads(filter) : refuse_threads(filter);
    return filter.load();
}

Result<void> filter_calls_of_reading_beneath() {
    Filter filter;
    for (const int call : calls_of_reading_beneath) filter.rule(SCMP_ACT_ALLOW, call);
    allow_looking_at_descriptors(filter);
    allow_memory_without_code(filter);
    return filter.load();
}

}  // namespace touchline
