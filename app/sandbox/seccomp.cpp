// Gives the rules of policy.h to the kernel, by libseccomp.
#include "app/sandbox/policy.h"
#include "app/sandbox/sandbox.h"

#include <cerrno>
#include <cstring>
#include <memory>
#include <span>
#include <string>

#include <seccomp.h>

namespace touchline {
namespace {

struct Release {
    void operator()(void* filter) const { seccomp_release(filter); }
};

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

Result<void> obey(std::span<const CallRule> rules) {
    const std::unique_ptr<void, Release> filter(seccomp_init(SCMP_ACT_KILL_PROCESS));
    const int error = filter ? load(filter.get(), rules) : -ENOMEM;
    if (error == 0) return {};
    return failure(std::string("the sandbox cannot be entered: seccomp: ") + std::strerror(-error));
}

}  // namespace

Result<void> filter_calls(WorkerKind kind) {
    return obey(call_rules(limits_of(kind)));
}

Result<void> filter_calls_of_reading_beneath() {
    return obey(call_rules_of_reading_beneath());
}

}  // namespace touchline
