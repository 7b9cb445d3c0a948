// The rigs of the back-ends, by name; each is in a file of its own. Threads: none.
#pragma once

#include "tests/haptics/device/conformance/device_rig.h"

#include <memory>

namespace touchline {

[[nodiscard]] std::unique_ptr<DeviceRig> board_rig();
[[nodiscard]] std::unique_ptr<DeviceRig> inverse3_rig();
[[nodiscard]] std::unique_ptr<DeviceRig> simulated_pantograph_rig();
[[nodiscard]] std::unique_ptr<DeviceRig> moteus_rig();
[[nodiscard]] std::unique_ptr<DeviceRig> odrive_rig();
[[nodiscard]] std::unique_ptr<DeviceRig> simulated_cartesian_rig();

}  // namespace touchline
