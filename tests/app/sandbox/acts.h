// What a captured worker might try.
#pragma once

#include <string_view>
#include <vector>

namespace touchline {

struct Act {
    std::string_view name;
    /// 0 or more: it worked. -1: refused, with errno.
    long (*run)();
    bool is_of_files = false;  // Landlock alone denies it too
    bool is_reading = false;   // Landlock alone denies it where fonts may be read
};

[[nodiscard]] const std::vector<Act>& acts();

/// What a process dies of that the filter of calls kills for the act: SIGSYS; SIGSEGV for a 32-bit
/// call where the kernel has none for anybody, which is tried in a process of its own.
[[nodiscard]] int deadly_signal(const Act& act);

/// Reads a file of the system, as a library does while it is prepared. As Act::run.
[[nodiscard]] long read_system_file();

}  // namespace touchline
