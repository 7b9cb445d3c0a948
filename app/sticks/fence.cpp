#include "app/sticks/fence.h"

#include "app/sandbox/limits.h"
#include "app/sandbox/sandbox.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>

#include <fcntl.h>
#include <linux/landlock.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr std::uint64_t all_rights_of_abi_2 = 0x3fff;

tl::unexpected<Error> refused(const std::string& step, int error) {
    return failure("the import cannot be shut in: " + step + ": " + std::strerror(error));
}

Result<void> die_with_parent() {
    if (prctl(PR_SET_PDEATHSIG, SIGKILL, 0UL, 0UL, 0UL) != 0) return refused("death signal", errno);
    if (prctl(PR_SET_DUMPABLE, 0UL, 0UL, 0UL, 0UL) != 0) return refused("tracing", errno);
    return {};
}

Descriptor rules_for(const Descriptor& root) {
    landlock_ruleset_attr handled{};
    handled.handled_access_fs = all_rights_of_abi_2;
    Descriptor rules(
        static_cast<int>(syscall(SYS_landlock_create_ruleset, &handled, sizeof(handled), 0)));
    landlock_path_beneath_attr beneath{};
    beneath.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
    beneath.parent_fd = root.number();
    if (rules.is_open() && syscall(SYS_landlock_add_rule, rules.number(),
                                   LANDLOCK_RULE_PATH_BENEATH, &beneath, 0) != 0) {
        return Descriptor();
    }
    return rules;
}

Result<void> read_only_beneath(const Descriptor& root) {
    const Descriptor rules = rules_for(root);
    if (!rules.is_open() || prctl(PR_SET_NO_NEW_PRIVS, 1UL, 0UL, 0UL, 0UL) != 0 ||
        syscall(SYS_landlock_restrict_self, rules.number(), 0) != 0) {
        return refused("Landlock", errno);
    }
    return {};
}

/// Paths come in by openat2 alone, whose flags lie in memory: Landlock judges those.
constexpr std::array allowed_calls{
    SCMP_SYS(openat2),      SCMP_SYS(getdents64), SCMP_SYS(read),         SCMP_SYS(write),
    SCMP_SYS(close),        SCMP_SYS(lseek),      SCMP_SYS(fstat),        SCMP_SYS(brk),
    SCMP_SYS(munmap),       SCMP_SYS(mremap),     SCMP_SYS(madvise),      SCMP_SYS(futex),
    SCMP_SYS(exit),         SCMP_SYS(exit_group), SCMP_SYS(rt_sigreturn), SCMP_SYS(getrandom),
    SCMP_SYS(clock_gettime)};

struct Release {
    void operator()(void* filter) const { seccomp_release(filter); }
};

Result<void> allow_calls() {
    const std::unique_ptr<void, Release> filter(seccomp_init(SCMP_ACT_KILL_PROCESS));
    if (!filter) return refused("seccomp", ENOMEM);
    const auto not_executable = SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0);
    int error = 0;
    for (const int call : allowed_calls)
        error |= seccomp_rule_add(filter.get(), SCMP_ACT_ALLOW, call, 0);
    error |= seccomp_rule_add(filter.get(), SCMP_ACT_ALLOW, SCMP_SYS(mmap), 1, not_executable);
    error |= seccomp_rule_add(filter.get(), SCMP_ACT_ALLOW, SCMP_SYS(mprotect), 1, not_executable);
    // What this C library makes of fstat(): a descriptor, no path.
    error |= seccomp_rule_add(filter.get(), SCMP_ACT_ALLOW, SCMP_SYS(newfstatat), 1,
                              SCMP_A3(SCMP_CMP_MASKED_EQ, AT_EMPTY_PATH, AT_EMPTY_PATH));
    if (error == 0) error = seccomp_load(filter.get());
    if (error != 0) return refused("seccomp", EINVAL);
    return {};
}

}  // namespace

Result<void> shut_in(const Descriptor& root, std::size_t most_bytes) {
    constexpr std::size_t most_memory_bytes = std::size_t{256} << 20U;
    WorkerLimits limits;
    limits.address_space_bytes = most_memory_bytes;
    limits.cpu_s = 10;
    limits.file_bytes = most_bytes;
    return die_with_parent()
        .and_then([&limits] { return limit_resources(limits); })
        .and_then([&root] { return read_only_beneath(root); })
        .and_then(allow_calls);
}

}  // namespace touchline
