// A board's node on the USB, opened: what one process passes to another, so that this one can turn
// the motors off without looking for the board, opening it or asking who has it.
// Threads: a value; write_zero() by one at a time.
#pragma once

#include "haptics/pantograph/profile.h"

#include <cstdint>
#include <string>

namespace touchline {

/// Addresses as the descriptors name them.
struct SerialPipes {
    int control_interface = 0;
    int data_interface = 1;
    std::uint8_t out_endpoint = 0;
    std::uint8_t in_endpoint = 0;
};

struct UsbNode {
    int descriptor = -1;  // of somebody else, who closes it
    SerialPipes pipes;
    std::string bus_path;  // as FoundBoard has it
};

/// Ends all transfers that are under way, whoever began them, and sends zero torque. True: all its
/// bytes went. Nobody else may drive the board by then, or their next write undoes it; what the
/// board answers is not read. Takes 20 ms at most, without a heap; 1 ms where all is well.
[[nodiscard]] bool write_zero(int descriptor, const SerialPipes& pipes,
                              const DeviceProfile& profile);

}  // namespace touchline
