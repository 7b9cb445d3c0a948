// The calls that a worker may make; any other kills it. Calls that a library merely tries and can
// do without (a configuration file, a thread) are refused instead.
#include "app/isolation/sandbox/policy.h"

#include "app/isolation/sandbox/sandbox.h"

#include <array>
#include <cerrno>

#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>

namespace touchline {
namespace {

/// Of every process that is shut in.
constexpr std::array plain_calls{
    SCMP_SYS(read),         SCMP_SYS(write),     SCMP_SYS(close),        SCMP_SYS(lseek),
    SCMP_SYS(fstat),        SCMP_SYS(brk),       SCMP_SYS(munmap),       SCMP_SYS(mremap),
    SCMP_SYS(madvise),      SCMP_SYS(futex),     SCMP_SYS(exit),         SCMP_SYS(exit_group),
    SCMP_SYS(rt_sigreturn), SCMP_SYS(getrandom), SCMP_SYS(clock_gettime)};

constexpr std::array calls_of_workers{
    SCMP_SYS(pread64),     SCMP_SYS(readv),          SCMP_SYS(pwrite64),
    SCMP_SYS(writev),      SCMP_SYS(ftruncate),      SCMP_SYS(gettimeofday),
    SCMP_SYS(sched_yield), SCMP_SYS(rt_sigprocmask), SCMP_SYS(sched_getaffinity)};

/// fontconfig, GLib, libexiv2, iconv and sorting try these, and go on without them. The C library
/// of arm64 asks readlinkat instead of readlink, which that kernel does not have; libseccomp
/// passes over what a kernel does not have.
constexpr std::array files_of_libraries{
    SCMP_SYS(readlink), SCMP_SYS(readlinkat), SCMP_SYS(statx),  SCMP_SYS(statfs),
    SCMP_SYS(getcwd),   SCMP_SYS(getdents64), SCMP_SYS(sysinfo)};

/// The flags of openat2 lie in memory, where no filter sees them; Landlock judges those calls.
constexpr std::array calls_of_reading_beneath{SCMP_SYS(openat2), SCMP_SYS(getdents64)};

constexpr std::array<const char*, 5> system_folders{"/usr", "/lib", "/etc/fonts",
                                                    "/etc/ld.so.cache", "/var/cache/fontconfig"};

/// poppler reads these while it draws: fonts that a PDF names and does not include.
constexpr std::array<const char*, 3> font_folders{"/usr/share/fonts", "/usr/local/share/fonts",
                                                  "/usr/share/poppler"};

using Rules = std::vector<CallRule>;

void allow(Rules& rules, int call, std::optional<MaskedArgument> where = {}) {
    rules.push_back({call, CallAnswer::allowed, 0, where});
}

void refuse(Rules& rules, int call, int error, std::optional<MaskedArgument> where = {}) {
    rules.push_back({call, CallAnswer::refused, static_cast<std::uint16_t>(error), where});
}

MaskedArgument has(unsigned argument, std::uint64_t bits) {
    return {argument, bits, bits};
}

MaskedArgument has_none(unsigned argument, std::uint64_t bits) {
    return {argument, bits, 0};
}

MaskedArgument equals(unsigned argument, std::uint64_t value) {
    return {argument, ~std::uint64_t{0}, value};
}

/// What every process that is shut in may call, and `further`; memory only without code in it.
Rules rules_allowing(std::span<const int> further) {
    Rules rules;
    for (const int call : plain_calls) allow(rules, call);
    for (const int call : further) allow(rules, call);
    // This C library's form of fstat(): a descriptor, no path.
    allow(rules, SCMP_SYS(newfstatat), has(3, AT_EMPTY_PATH));
    allow(rules, SCMP_SYS(mmap), has_none(2, PROT_EXEC));
    allow(rules, SCMP_SYS(mprotect), has_none(2, PROT_EXEC));
    return rules;
}

/// Allows threads of this process, but no new process.
void allow_threads(Rules& rules) {
    refuse(rules, SCMP_SYS(clone3), ENOSYS);  // its flags lie in memory
    allow(rules, SCMP_SYS(clone), has(0, CLONE_THREAD | CLONE_VM));
    refuse(rules, SCMP_SYS(rt_sigaction), EPERM);  // by the C library, before the first thread
    refuse(rules, SCMP_SYS(prctl), 0, equals(0, PR_SET_NAME));
    allow(rules, SCMP_SYS(set_robust_list));
    allow(rules, SCMP_SYS(rseq));
}

/// Files that Landlock leaves readable can be opened for reading; nothing can be opened for
/// writing.
void allow_reading_fonts(Rules& rules) {
    constexpr int changes = O_ACCMODE | O_CREAT | O_TRUNC | O_APPEND | O_PATH | O_TMPFILE;
    allow(rules, SCMP_SYS(openat), has_none(2, changes & ~O_DIRECTORY));
    allow(rules, SCMP_SYS(fcntl), equals(1, F_SETFD));
    allow(rules, SCMP_SYS(fcntl), equals(1, F_GETFL));  // by std::filesystem, since Debian 13
    for (const int change : {O_WRONLY, O_RDWR, O_CREAT})
        refuse(rules, SCMP_SYS(openat), EACCES, has(2, static_cast<std::uint64_t>(change)));
}

void refuse_what_libraries_try(Rules& rules, const WorkerLimits& limits) {
    for (const int call : files_of_libraries) refuse(rules, call, EACCES);
    // Libraries ask this for every font, even loaded ones; the answer is always that it exists.
    for (const int call : {SCMP_SYS(access), SCMP_SYS(faccessat)}) refuse(rules, call, 0);
    refuse(rules, SCMP_SYS(newfstatat), EACCES, has_none(3, AT_EMPTY_PATH));
    limits.reads_fonts ? allow_reading_fonts(rules) : refuse(rules, SCMP_SYS(openat), EACCES);
}

}  // namespace

std::vector<CallRule> call_rules(const WorkerLimits& limits) {
    Rules rules = rules_allowing(calls_of_workers);
    refuse_what_libraries_try(rules, limits);
    limits.has_threads ? allow_threads(rules) : refuse(rules, SCMP_SYS(clone3), EAGAIN);
    return rules;
}

std::vector<CallRule> call_rules_of_reading_beneath() {
    return rules_allowing(calls_of_reading_beneath);
}

std::span<const char* const> folders_of_the_system() {
    return system_folders;
}

std::span<const char* const> folders_of_work(const WorkerLimits& limits) {
    if (limits.reads_fonts) return font_folders;
    return {};
}

std::vector<ResourceLimit> resource_limits(const WorkerLimits& limits, bool has_memory_limit) {
    std::vector<ResourceLimit> most;
    const auto limit = [&most](int what, const char* name, std::uint64_t value) {
        most.push_back({what, name, value, value});
    };
    limit(RLIMIT_AS, "memory",
          has_memory_limit ? limits.address_space_bytes : ResourceLimit::no_limit);
    if (limits.cpu_s != 0)
        most.push_back({RLIMIT_CPU, "processor time", limits.cpu_s, limits.cpu_s + 1U});
    limit(RLIMIT_FSIZE, "size of files", limits.file_bytes);
    limit(RLIMIT_NOFILE, "files", worker_descriptors + 3);
    limit(RLIMIT_CORE, "core dumps", 0);
    if (!limits.has_threads) limit(RLIMIT_NPROC, "processes", 0);
    return most;
}

}  // namespace touchline
