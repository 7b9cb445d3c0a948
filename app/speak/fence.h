// What the voice may not do once it reads texts. Threads: the only one of its process.
#pragma once

#include "config/types/result.h"

namespace touchline {

/// Prints nothing, dies with its parent, cannot be traced, gains no rights, opens no file, writes
/// none, starts no process (unless root), takes 256 MiB at most, leaves no core. Not to be undone.
/// What it needs from files must have been read before. One line where the system refuses.
[[nodiscard]] Result<void> shut_in();

}  // namespace touchline
