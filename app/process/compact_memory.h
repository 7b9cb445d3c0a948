// A program that runs for months must not grow by what glibc keeps for speed.
// Threads: at the start of main.
#pragma once

#include <malloc.h>

namespace touchline {

/// One arena for all threads, and large blocks mapped by themselves and given back when freed. With
/// an arena a thread and a threshold that grows with what was freed, pictures that were loaded on
/// many short-lived threads left some megabytes an hour behind, in holes nobody filled.
inline void keep_memory_compact() {
    constexpr int large_bytes = 128 * 1024;
    (void)mallopt(M_ARENA_MAX, 1);
    (void)mallopt(M_MMAP_THRESHOLD, large_bytes);
}

}  // namespace touchline
