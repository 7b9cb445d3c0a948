// Sends a signal to one process. kill() takes 0 and -1 for many, up to all that the user has, and
// -1 is what a process that did not start is often called. Threads: any.
#pragma once

#include <csignal>
#include <stdexcept>

#include <sys/types.h>

namespace touchline {

/// Throws if `process` names none, or more than one.
inline void signal_one(pid_t process, int signal) {
    if (process <= 0) throw std::invalid_argument("there is no process to send a signal to");
    (void)kill(process, signal);
}

}  // namespace touchline
