// Chooses how sticks are detected, by the operator's settings.
// Threads: one.
#pragma once

#include "app/sticks/stick_port.h"

#include <memory>
#include <string>

namespace touchline {

/// The watched folder if the settings name one, else udisks2.
[[nodiscard]] std::unique_ptr<StickPort> open_stick_port(const std::string& watched_folder);

}  // namespace touchline
