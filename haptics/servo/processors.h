// Which processor is the servo's. Threads: any.
#pragma once

#include <cstddef>

#include <sched.h>

namespace touchline {

/// The last that `allowed` names, which is not empty: interrupts and windows live on the first.
[[nodiscard]] inline std::size_t servos_processor(const cpu_set_t& allowed) {
    std::size_t last = CPU_SETSIZE - 1;
    while (last > 0 && !CPU_ISSET(last, &allowed)) --last;
    return last;
}

}  // namespace touchline
