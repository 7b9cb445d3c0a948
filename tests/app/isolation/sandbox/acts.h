// What a captured worker might try.
#pragma once

#include <string_view>
#include <vector>

namespace touchline {

struct Act {
    std::string_view name;
    /// Returns 0 or more if it worked; -1, with errno, if it was refused.
    long (*run)();
    bool is_of_files = false;  // Landlock alone denies it too
    bool is_reading = false;   // Landlock alone denies it if fonts may be read
};

[[nodiscard]] const std::vector<Act>& acts();

/// Returns the signal that ends a process whose call the filter kills for this act: SIGSYS, or
/// SIGSEGV for a 32-bit call if the kernel has none at all, which is tried in a separate process.
[[nodiscard]] int deadly_signal(const Act& act);

/// Reads a system file, as a library does during preparation. Returns like Act::run.
[[nodiscard]] long read_system_file();

}  // namespace touchline
