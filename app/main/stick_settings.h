// The operator's file that says where visitors' files come from.
// Threads: any; the call waits for the disk.
#pragma once

#include "config/settings/sticks.h"

namespace touchline {

/// Of TOUCHLINE_STICKS, else of the installed file. Errors are one line with the file's name.
[[nodiscard]] Result<StickSettings> read_stick_settings();

}  // namespace touchline
