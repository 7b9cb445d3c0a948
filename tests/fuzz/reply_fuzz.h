// What must hold for any packets from a board, whatever they are. Throws nothing; ends the program
// where something does not hold. Threads: pure.
#pragma once

#include <cstdint>
#include <span>

namespace touchline {

/// The bytes are packets, each with its length first; a tick takes what came since the last one.
void feed_packets(std::span<const std::uint8_t> bytes);

}  // namespace touchline
