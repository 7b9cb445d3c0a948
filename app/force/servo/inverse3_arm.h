// The Inverse3 as a servo's device: opened through its maker's service, and told zero when its
// servo is dead. Threads: any; both calls wait.
#pragma once

#include "app/force/servo/servo_program.h"
#include "config/types/result.h"
#include "haptics/device/inverse3/inverse3_service.h"

#include <cstdint>
#include <string>

namespace touchline {

/// Waits until the device of this name (empty: the only one) is fit for force, with words for the
/// person who can make it so. It knows where its handle is: nothing is homed.
[[nodiscard]] Result<OpenedDevice> open_inverse3(const std::string& name, const Opening& opening,
                                                 std::uint16_t port = inverse3_port);

/// Tells zero in a conversation of its own. Nothing if the service answered and says that it
/// applies no force. Takes 2.5 s at most.
[[nodiscard]] Result<void> zero_inverse3(const std::string& name,
                                         std::uint16_t port = inverse3_port);

}  // namespace touchline
