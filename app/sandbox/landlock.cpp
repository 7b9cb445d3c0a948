// Landlock: no path can be opened, made, removed or run. Asked for exactly what Debian 12's kernel
// (ABI 2) knows, so that a newer kernel does not prove more here than holds there.
#include "app/sandbox/sandbox.h"

#include <cerrno>
#include <cstdint>
#include <cstring>

#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr std::uint64_t all_rights_of_abi_2 = 0x3fff;
constexpr long least_abi = 2;

}  // namespace

Result<void> deny_files() {
    const long abi =
        syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    if (abi < least_abi)
        return failure("the sandbox cannot be entered: this kernel has no Landlock, or an old one");
    landlock_ruleset_attr rules{};
    rules.handled_access_fs = all_rights_of_abi_2;
    const long ruleset = syscall(SYS_landlock_create_ruleset, &rules, sizeof(rules), 0);
    const bool is_on = ruleset >= 0 && prctl(PR_SET_NO_NEW_PRIVS, 1UL, 0UL, 0UL, 0UL) == 0 &&
                       syscall(SYS_landlock_restrict_self, ruleset, 0) == 0;
    const int error = errno;
    if (ruleset >= 0) close(static_cast<int>(ruleset));
    if (!is_on)
        return failure(std::string("the sandbox cannot be entered: Landlock: ") +
                       std::strerror(error));
    return {};
}

}  // namespace touchline
