// A process that shuts itself in before it reads what a stranger brought: no file can be opened
// (fonts apart, where documents are drawn), no process started, no network reached, no memory made
// executable. Landlock and seccomp each deny on their own; where either is missing nothing is read.
// Threads: the only one of its process.
#pragma once

#include "app/sandbox/limits.h"
#include "config/types/result.h"

namespace touchline {

/// The descriptors that a worker is started with, besides 0 to 2.
inline constexpr int worker_input = 3;
inline constexpr int worker_output = 4;
inline constexpr int worker_descriptors = 5;

/// Before libraries are prepared that start threads of their own: Landlock binds only the thread
/// that asks, and those it starts later. From here on the system's own files can be read, and
/// nothing else.
[[nodiscard]] Result<void> allow_only_reading_the_system();

/// In this order: dies with its parent, cannot be traced, closes what it was not meant to have,
/// limits (limits.h), no new privileges, Landlock, seccomp. Not to be undone. What the work needs
/// from files (fonts, dictionaries) must have been read before. On failure the process must end at
/// once; the line says which step failed.
[[nodiscard]] Result<void> enter_sandbox(WorkerKind kind);

/// The steps of enter_sandbox() that deny, singly, for their tests.
[[nodiscard]] Result<void> limit_resources(const WorkerLimits& limits);
[[nodiscard]] Result<void> deny_files(WorkerKind kind);
[[nodiscard]] Result<void> filter_calls(WorkerKind kind);

}  // namespace touchline
