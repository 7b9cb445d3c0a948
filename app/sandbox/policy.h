// What each kind of worker may do, as values: which calls, which files, how much. Nothing here asks
// the kernel; seccomp.cpp, landlock.cpp and sandbox.cpp tell it.
// Threads: constant data and pure functions.
#pragma once

#include "app/sandbox/limits.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace touchline {

/// Holds where (argument & mask) == value.
struct MaskedArgument {
    unsigned argument = 0;  // 0 ... 5, of the call
    std::uint64_t mask = 0;
    std::uint64_t value = 0;

    friend bool operator==(const MaskedArgument&, const MaskedArgument&) = default;
};

enum class CallAnswer : std::uint8_t { allowed, refused };

/// A call that no rule holds for kills the process. No two rules with different answers hold at
/// once.
struct CallRule {
    int call = 0;  // its number, as libseccomp counts
    CallAnswer answer = CallAnswer::allowed;
    std::uint16_t error = 0;  // refused: what the caller is told; 0: that it was done
    std::optional<MaskedArgument> where;
};

/// Of a worker that reads its descriptors, and fonts where `limits` says so.
[[nodiscard]] std::vector<CallRule> call_rules(const WorkerLimits& limits);

/// Of a process that reads the files below one folder.
[[nodiscard]] std::vector<CallRule> call_rules_of_reading_beneath();

/// What libraries read while they are prepared: themselves, their settings, fonts. Nothing else is
/// read from then on.
[[nodiscard]] std::span<const char* const> folders_of_the_system();

/// What is read beyond that while the work is done: fonts, or nothing.
[[nodiscard]] std::span<const char* const> folders_of_work(const WorkerLimits& limits);

/// As for setrlimit(); no_limit where there is none.
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
