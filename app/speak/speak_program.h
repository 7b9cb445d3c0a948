// touchline-speak from within: orders in, samples out. Threads: the only one of its process.
#pragma once

#include <string>

namespace touchline {

/// Gets the voice ready, shuts itself in (app/sandbox), waits at the descriptor worker_input, a
/// socket of packets, for one order, says it (messages.h) and ends: what one stranger wrote never
/// meets what the next one does, and the same text always gives the same samples. Exit status:
/// 0 all said, 1 no voice, no order or nobody who listens, worker_refused_to_start.
[[nodiscard]] int run_speak_program(const std::string& voice);

}  // namespace touchline
