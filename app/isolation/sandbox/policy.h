// What each kind of worker may do, as values: which calls, which files, how much. This file asks
// nothing of the kernel; fences.cpp and sandbox.cpp do.
// Threads: constant data and pure functions.
#pragma once

#include "app/isolation/sandbox/limits.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace touchline {

/// True if (argument & mask) == value.
struct MaskedArgument {
    unsigned argument = 0;  // index of the call's argument, 0 ... 5
    std::uint64_t mask = 0;
    std::uint64_t value = 0;

    friend bool operator==(const MaskedArgument&, const MaskedArgument&) = default;
};

enum class CallAnswer : std::uint8_t { allowed, refused };

/// A call that matches no rule kills the process. No two rules with different answers match at
/// once.
struct CallRule {
    int call = 0;  // its number in libseccomp
    CallAnswer answer = CallAnswer::allowed;
    std::uint16_t error = 0;  // refused: the errno that the caller gets; 0: success
    std::optional<MaskedArgument> where;
};

/// For a worker that reads its descriptors, and fonts if `limits` says so.
[[nodiscard]] std::vector<CallRule> call_rules(const WorkerLimits& limits);

/// For a process that reads the files below one folder.
[[nodiscard]] std::vector<CallRule> call_rules_of_reading_beneath();

/// What libraries read during preparation: themselves, their settings, fonts. Nothing else can be
/// read from then on.
[[nodiscard]] std::span<const char* const> folders_of_the_system();

/// What is also read during the work: fonts, or nothing.
[[nodiscard]] std::span<const char* const> folders_of_work(const WorkerLimits& limits);

/// As for setrlimit(); no_limit for none.
struct ResourceLimit {
    int what = 0;
    const char* name = "";
    std::uint64_t soft = 0;
    std::uint64_t hard = 0;  // >= soft

    static constexpr std::uint64_t no_limit = ~std::uint64_t{0};
};

/// `has_memory_limit`: false for the sanitizers, which map terabytes.
[[nodiscard]] std::vector<ResourceLimit> resource_limits(const WorkerLimits& limits,
                                                         bool has_memory_limit);

}  // namespace touchline
