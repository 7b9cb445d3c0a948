// Whether somebody wants a command that drives a device to end. Threads: any.
#pragma once

namespace touchline {

/// Keeps SIGINT, SIGTERM and SIGHUP from now on; they do not end the process any more.
void catch_stop_signals();

/// True once one of them came.
[[nodiscard]] bool is_stop_wanted();

}  // namespace touchline
