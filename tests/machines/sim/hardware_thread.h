// A thread that stands for hardware, which is never busy. Threads: the calling one.
#pragma once

#include <sched.h>

namespace touchline {

/// Gives this thread priority over everything under test, if that is granted.
inline void become_hardware() {
    const sched_param priority{95};
    (void)sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &priority);
}

}  // namespace touchline
