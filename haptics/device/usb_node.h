// A board's USB node, opened. One process passes it to another, which can then turn the motors off
// without looking for the board, opening it or asking who has it.
// Threads: a value; write_zero() by one at a time.
#pragma once

#include "haptics/pantograph/profile.h"

#include <cstdint>
#include <string>

namespace touchline {

/// Addresses, as in the descriptors.
struct SerialPipes {
    int control_interface = 0;
    int data_interface = 1;
    std::uint8_t out_endpoint = 0;
    std::uint8_t in_endpoint = 0;
};

struct UsbNode {
    int descriptor = -1;  // owned and closed by somebody else
    SerialPipes pipes;
    std::string bus_path;  // as in FoundBoard
};

/// Ends all transfers under way, whoever began them, and sends zero torque. Returns true if all its
/// bytes went. Nobody else may drive the board by then, or their next write undoes it. The board's
/// answer is not read. Takes 20 ms at most, without a heap; 1 ms if all is well.
[[nodiscard]] bool write_zero(int descriptor, const SerialPipes& pipes,
                              const DeviceProfile& profile);

}  // namespace touchline
