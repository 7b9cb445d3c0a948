// A visitor's data must not stay on a disk, so a program that crashes leaves no memory image.
// Threads: at the start of main.
#pragma once

#include <sys/prctl.h>
#include <sys/resource.h>

namespace touchline {

/// Forbids core dumps of this process and of those it starts.
inline void forbid_core_dumps() {
    const rlimit none{0, 0};
    // The system never refuses to lower a limit or give up a right.
    (void)setrlimit(RLIMIT_CORE, &none);
    (void)prctl(PR_SET_DUMPABLE, 0UL, 0UL, 0UL, 0UL);
}

}  // namespace touchline
