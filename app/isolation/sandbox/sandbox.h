// A process closes its sandbox before it reads untrusted input: it can open no file (except fonts,
// if it draws documents), start no process, reach no network, and make no memory executable.
// Landlock and seccomp each deny on their own; if either is missing, nothing is read.
// Threads: the only one of its process.
#pragma once

#include "app/isolation/process/descriptor.h"
#include "app/isolation/sandbox/limits.h"
#include "config/types/result.h"

namespace touchline {

/// The descriptors that a worker starts with, besides 0 to 2.
inline constexpr int worker_input = 3;
inline constexpr int worker_output = 4;
inline constexpr int worker_descriptors = 5;

/// When the machine has no memory left, this process is killed before all others. Call it once, as
/// early as possible: later no file of the system can be written. If the system refuses, the worker
/// goes on, because its own limit of memory still holds.
void be_killed_first();

/// Call it before preparing libraries that start threads of their own: Landlock binds only the
/// calling thread, and those it starts later. From here on the process can read the system's own
/// files, and nothing else.
[[nodiscard]] Result<void> allow_only_reading_the_system();

/// In this order: the process is killed first if memory is short, dies with its parent, cannot be
/// traced, closes stray descriptors, gets its limits (limits.h), no new privileges, Landlock,
/// seccomp. This cannot be undone. What the work needs from files (fonts, dictionaries) must have
/// been read before. If it fails, the process must end at once; the line says which step failed.
[[nodiscard]] Result<void> enter_sandbox(WorkerKind kind);

/// The same for a process that reads only the files below one folder while it is in the sandbox: it
/// names them only by openat2(). Its descriptors stay open.
[[nodiscard]] Result<void> enter_sandbox_beneath(const Descriptor& folder,
                                                 const WorkerLimits& limits);

/// The steps of both that deny, one by one, for their tests.
[[nodiscard]] Result<void> deny_files(WorkerKind kind);
[[nodiscard]] Result<void> deny_files_but_beneath(const Descriptor& folder);
[[nodiscard]] Result<void> filter_calls(WorkerKind kind);
[[nodiscard]] Result<void> filter_calls_of_reading_beneath();

}  // namespace touchline
