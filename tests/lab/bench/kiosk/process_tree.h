// A program and all that it started, as the system counts them. Threads: any.
#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

namespace touchline {

/// `root` and its descendants, `root` first. O(processes of the machine).
[[nodiscard]] std::vector<pid_t> tree_of(pid_t root);

/// Processor time of these processes and of their children that have ended, s, in steps of 0.01 s.
[[nodiscard]] double processor_time_s(const std::vector<pid_t>& processes);

struct TreeMemory {
    double all_MB = 0.0;     // proportional set size, without the figure's worker; 0: not readable
    double figure_MB = 0.0;  // of the figure's worker
};

/// What these processes hold. Only root may read it of a process that leaves no core dump.
[[nodiscard]] TreeMemory memory_of(const std::vector<pid_t>& processes);

/// The files that a process has mapped.
[[nodiscard]] std::vector<std::string> mapped_files(pid_t process);

/// Takes the file out of the page cache, as far as no process has it mapped.
void forget_cached(const std::string& path);

}  // namespace touchline
