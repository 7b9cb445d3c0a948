// The Inverse3 as a servo's device: opened through its maker's service, and told zero when its
// servo is dead. Threads: any; both calls wait.
#pragma once

#include "app/force/servo/servo_program.h"
#include "config/types/result.h"
#include "haptics/device/inverse3/inverse3_service.h"

#include <cstdint>
#include <string>

namespace touchline {

/// A device behind a service on this computer.
struct ArmAddress {
    std::string name;  // as it is printed on the device; empty: the only one
    std::uint16_t port = inverse3_port;
};

/// Reads "NAME", "NAME@PORT", "@PORT" or nothing, as the setting device.port has it. Fails in one
/// line if the name can be no device's, or the port is not from 1 to 65535.
[[nodiscard]] Result<ArmAddress> arm_address_of(const std::string& text);

/// Waits until the device is fit for force, with words for the person who can make it so. It knows
/// where its handle is: nothing is homed.
[[nodiscard]] Result<OpenedDevice> open_inverse3(const ArmAddress& address, const Opening& opening);

/// Tells zero in a conversation of its own. Nothing if the service answered and says that it
/// applies no force. Takes 2.5 s at most.
[[nodiscard]] Result<void> zero_inverse3(const ArmAddress& address);

}  // namespace touchline
