// What a worker leaves to the others on the machine: memory when it is short, and threads.
// Threads: the only one of its process, but for those that libraries have started.
#pragma once

#include "config/types/result.h"

namespace touchline {

/// When the machine has no memory left this process is killed before all others. Asked once, as
/// early as can be: later no file of the system can be written. Where it is refused the worker goes
/// on: its own limit of memory holds all the same.
void be_killed_first();

/// From here on this user can start most_worker_threads more (limits.h), of this process or of
/// another. Root is bound by no such limit. Some 0.2 ms.
[[nodiscard]] Result<void> limit_threads();

}  // namespace touchline
