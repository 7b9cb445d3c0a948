// What a worker leaves to others on the machine: memory when it is short, and threads.
// Threads: the only one of its process, except those that libraries have started.
#pragma once

#include "config/types/result.h"

namespace touchline {

/// When the machine has no memory left, this process is killed before all others. Call it once, as
/// early as possible: later no file of the system can be written. If the system refuses, the worker
/// goes on, because its own limit of memory still holds.
void be_killed_first();

/// From here on this user can start most_worker_threads more (limits.h), in this process or
/// another. The limit does not bind root. Takes some 0.2 ms.
[[nodiscard]] Result<void> limit_threads();

}  // namespace touchline
