// The makes of device that touchline-servo can drive, a row each. The first word of its command
// line names the row; the other words are the row's own (kiosk_backends.h makes them). Threads:
// constant data; opening waits.
#pragma once

#include "app/force/servo/servo_program.h"
#include "config/types/result.h"

#include <span>
#include <string>
#include <string_view>

namespace touchline {

struct ServoBackend {
    std::string_view name;
    /// False if the words cannot be what the kiosk starts this servo with.
    bool (*is_sound)(std::span<const std::string> words) = nullptr;
    /// As DeviceOpener.
    Result<OpenedDevice> (*open)(std::span<const std::string> words,
                                 const Opening& opening) = nullptr;
};

[[nodiscard]] std::span<const ServoBackend> servo_backends();

/// Returns whether a row is named and its words are sound.
[[nodiscard]] bool names_device(std::span<const std::string> words);

/// Opens the device that the words name.
[[nodiscard]] Result<OpenedDevice> open_named_device(std::span<const std::string> words,
                                                     const Opening& opening);

}  // namespace touchline
