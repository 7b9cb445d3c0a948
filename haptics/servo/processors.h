// Which processor the servo runs on. Threads: any.
#pragma once

#include <cstddef>

#include <sched.h>

namespace touchline {

/// Returns the last processor in `allowed`, which is not empty: interrupts and windows use the
/// first ones.
[[nodiscard]] inline std::size_t servos_processor(const cpu_set_t& allowed) {
    std::size_t last = CPU_SETSIZE - 1;
    while (last > 0 && !CPU_ISSET(last, &allowed)) --last;
    return last;
}

}  // namespace touchline
