// Whether somebody wants a command that drives a device to end. Threads: any.
#pragma once

namespace touchline {

/// From now on SIGINT, SIGTERM and SIGHUP do not end the process but are kept.
void catch_stop_signals();

/// True once one of them came.
[[nodiscard]] bool is_stop_wanted();

}  // namespace touchline
