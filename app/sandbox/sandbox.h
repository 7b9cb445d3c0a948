// A process that shuts itself in before it reads untrusted input: no file can be opened
// (fonts apart, where documents are drawn), no process started, no network reached, no memory made
// executable. Landlock and seccomp each deny on their own; where either is missing nothing is read.
// Threads: the only one of its process.
#pragma once

#include "app/process/descriptor.h"
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

/// In this order: is killed first where memory is short, dies with its parent, cannot be traced,
/// closes what it was not meant to have, limits (limits.h), no new privileges, Landlock, seccomp.
/// Not to be undone. What the work needs from files (fonts, dictionaries) must have been read
/// before. On failure the process must end at once; the line says which step failed.
[[nodiscard]] Result<void> enter_sandbox(WorkerKind kind);

/// The same for a process that reads the files below one folder, and no others, while it is shut
/// in: it names them by openat2() alone. Its descriptors stay open.
[[nodiscard]] Result<void> enter_sandbox_beneath(const Descriptor& folder,
                                                 const WorkerLimits& limits);

/// The steps of both that deny, singly, for their tests.
[[nodiscard]] Result<void> limit_resources(const WorkerLimits& limits);
[[nodiscard]] Result<void> deny_files(WorkerKind kind);
[[nodiscard]] Result<void> deny_files_but_beneath(const Descriptor& folder);
[[nodiscard]] Result<void> filter_calls(WorkerKind kind);
[[nodiscard]] Result<void> filter_calls_of_reading_beneath();

}  // namespace touchline
