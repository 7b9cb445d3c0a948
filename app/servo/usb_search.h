// Which pantograph on the USB the kiosk is to use: its side only, for it reads files.
// Threads: any; the calls wait.
#pragma once

#include "app/servo/usb_device.h"
#include "config/settings/boards.h"
#include "config/types/result.h"

#include <optional>

namespace touchline {

/// The first running board that can be opened: one with settings of its own, or one that may be
/// probed; of one without settings nobody knows which kind it is. Nothing when no board is plugged
/// in. A board that is there but cannot be used is an error, with what to do about it.
[[nodiscard]] Result<std::optional<UsbDevice>> find_usb_device(const BoardSettings& settings);

}  // namespace touchline
