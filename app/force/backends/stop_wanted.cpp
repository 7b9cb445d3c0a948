#include "app/force/backends/stop_wanted.h"

#include <atomic>
#include <csignal>

namespace touchline {
namespace {

std::atomic<bool> has_stop_come{false};

void want_stop(int) {
    has_stop_come = true;
}

}  // namespace

void catch_stop_signals() {
    static_assert(std::atomic<bool>::is_always_lock_free);
    std::signal(SIGINT, want_stop);
    std::signal(SIGTERM, want_stop);
    std::signal(SIGHUP, want_stop);
}

bool is_stop_wanted() {
    return has_stop_come;
}

}  // namespace touchline
