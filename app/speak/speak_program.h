// touchline-speak from within: orders in, samples out. Threads: the only one of its process.
#pragma once

#include <string>

namespace touchline {

/// Gets the voice ready, shuts itself in (fence.h), waits at `socket` (a number, of packets) for
/// one order, says it (messages.h) and ends: what one stranger wrote never meets what the next one
/// does, and the same text always gives the same samples. Exit status.
[[nodiscard]] int run_speak_program(int socket, const std::string& voice);

}  // namespace touchline
