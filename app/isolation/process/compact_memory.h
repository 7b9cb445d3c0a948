// Keeps a program that runs for months from growing by memory that glibc keeps for speed.
// Threads: at the start of main.
#pragma once

#include <malloc.h>

namespace touchline {

/// Uses one arena for all threads, and maps large blocks singly, so that they are given back when
/// freed. With an arena per thread, and a threshold that grows with freed blocks, pictures loaded
/// on many short-lived threads left some megabytes an hour behind, in holes that nobody filled.
inline void keep_memory_compact() {
    constexpr int large_bytes = 128 * 1024;
    (void)mallopt(M_ARENA_MAX, 1);
    (void)mallopt(M_MMAP_THRESHOLD, large_bytes);
}

}  // namespace touchline
