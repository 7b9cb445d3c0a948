// What a visitor brought must not stay on a disk: a program that crashes leaves no image of itself.
// Threads: at the start of main.
#pragma once

#include <sys/prctl.h>
#include <sys/resource.h>

namespace touchline {

/// No core dumps of this process, nor of those it starts.
inline void forbid_core_dumps() {
    const rlimit none{0, 0};
    // Lowering a limit and giving up a right are never refused.
    (void)setrlimit(RLIMIT_CORE, &none);
    (void)prctl(PR_SET_DUMPABLE, 0UL, 0UL, 0UL, 0UL);
}

}  // namespace touchline
