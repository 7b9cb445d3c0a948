// Finds the pantograph on the USB that the kiosk uses. Only for the kiosk's side, because it reads
// files.
// Threads: any; the calls wait.
#pragma once

#include "app/force/servo/usb_device.h"
#include "config/settings/boards.h"
#include "config/types/result.h"

#include <optional>

namespace touchline {

/// Returns the first running board that can be opened: one with settings of its own, or one that
/// may be probed. Without settings its kind is unknown. Nothing if no board is plugged in. A board
/// that is plugged in but cannot be used is an error, with what to do about it.
[[nodiscard]] Result<std::optional<UsbDevice>> find_usb_device(const BoardSettings& settings);

}  // namespace touchline
