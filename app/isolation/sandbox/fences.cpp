// The two fences of a worker, as the kernel is told of them.
//
// Landlock: the process can make, change, remove or run nothing, and read only what is named. Asks
// for exactly what Debian 12's kernel (ABI 2) supports, so that tests on a newer kernel do not
// prove more than is true there. seccomp: gives the rules of policy.h to the kernel, by libseccomp.
#include "app/isolation/process/descriptor.h"
#include "app/isolation/sandbox/policy.h"
#include "app/isolation/sandbox/sandbox.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

#include <fcntl.h>
#include <linux/landlock.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr std::uint64_t all_rights_of_abi_2 = 0x3fff;
constexpr long least_abi = 2;

tl::unexpected<Error> refused(const char* why) {
    return failure(std::string("the sandbox cannot be entered: Landlock: ") + why);
}

/// It allows nothing yet.
Result<Descriptor> new_ruleset() {
    const long abi =
        syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    if (abi < least_abi) return refused("this kernel has none, or an old one");
    landlock_ruleset_attr rules{};
    rules.handled_access_fs = all_rights_of_abi_2;
    Descriptor ruleset(
        static_cast<int>(syscall(SYS_landlock_create_ruleset, &rules, sizeof(rules), 0)));
    if (!ruleset.is_open()) return refused(std::strerror(errno));
    return ruleset;
}

bool allow_reading(const Descriptor& ruleset, const Descriptor& place) {
    landlock_path_beneath_attr rule{};
    rule.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE;
    if (::faccessat(place.number(), ".", F_OK, 0) == 0)
        rule.allowed_access |= LANDLOCK_ACCESS_FS_READ_DIR;
    rule.parent_fd = place.number();
    return syscall(SYS_landlock_add_rule, ruleset.number(), LANDLOCK_RULE_PATH_BENEATH, &rule, 0) ==
           0;
}

Result<void> obey(const Descriptor& ruleset) {
    const bool is_on = prctl(PR_SET_NO_NEW_PRIVS, 1UL, 0UL, 0UL, 0UL) == 0 &&
                       syscall(SYS_landlock_restrict_self, ruleset.number(), 0) == 0;
    return is_on ? Result<void>{} : refused(std::strerror(errno));
}

/// A missing folder is skipped: nothing in it needs to be read.
Result<void> restrict_to_reading(std::span<const char* const> folders) {
    const auto ruleset = new_ruleset();
    if (!ruleset) return tl::unexpected(ruleset.error());
    for (const char* folder : folders) {
        const Descriptor place(::open(folder, O_PATH | O_CLOEXEC));
        if (!place.is_open() && errno == ENOENT) continue;
        if (!place.is_open() || !allow_reading(*ruleset, place)) return refused(folder);
    }
    return obey(*ruleset);
}

int add(scmp_filter_ctx filter, const CallRule& rule) {
    const std::uint32_t action =
        rule.answer == CallAnswer::allowed ? SCMP_ACT_ALLOW : SCMP_ACT_ERRNO(rule.error);
    if (!rule.where) return seccomp_rule_add(filter, action, rule.call, 0);
    const scmp_arg_cmp where{rule.where->argument, SCMP_CMP_MASKED_EQ, rule.where->mask,
                             rule.where->value};
    return seccomp_rule_add(filter, action, rule.call, 1, where);
}

/// A call that no rule allows kills the process, not just the thread that makes it, and so does a
/// call of another architecture. The rules also apply to threads that a library has started.
int load(scmp_filter_ctx filter, std::span<const CallRule> rules) {
    int error = seccomp_attr_set(filter, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
    if (error == 0) error = seccomp_attr_set(filter, SCMP_FLTATR_CTL_TSYNC, 1);
    for (const CallRule& rule : rules)
        if (error == 0) error = add(filter, rule);
    return error == 0 ? seccomp_load(filter) : error;
}

Result<void> filter_by(std::span<const CallRule> rules) {
    const Owned<void, seccomp_release> filter(seccomp_init(SCMP_ACT_KILL_PROCESS));
    const int error = filter ? load(filter.get(), rules) : -ENOMEM;
    if (error == 0) return {};
    return failure(std::string("the sandbox cannot be entered: seccomp: ") + std::strerror(-error));
}

}  // namespace

Result<void> allow_only_reading_the_system() {
    be_killed_first();
    return restrict_to_reading(folders_of_the_system());
}

Result<void> deny_files(WorkerKind kind) {
    return restrict_to_reading(folders_of_work(limits_of(kind)));
}

Result<void> deny_files_but_beneath(const Descriptor& folder) {
    const auto ruleset = new_ruleset();
    if (!ruleset) return tl::unexpected(ruleset.error());
    if (!allow_reading(*ruleset, folder)) return refused("the folder");
    return obey(*ruleset);
}

Result<void> filter_calls(WorkerKind kind) {
    return filter_by(call_rules(limits_of(kind)));
}

Result<void> filter_calls_of_reading_beneath() {
    return filter_by(call_rules_of_reading_beneath());
}

}  // namespace touchline
