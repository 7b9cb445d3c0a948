// Signals are the main thread's business. Threads: any.
#pragma once

#include <pthread.h>
#include <signal.h>

namespace touchline {

/// The calling thread takes no signals from now on, nor do threads that it starts.
inline void leave_signals_to_main_thread() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace touchline
