// touchline device: which boards there are, and setting one up.
// Threads: one; SIGINT and SIGTERM end a command with zero torque.
#pragma once

#include "config/types/result.h"

#include <cstdint>
#include <iosfwd>
#include <string>

namespace touchline {

/// list: boards that are plugged in. probe: whether one answers, and how fast. home: the person
/// leads the handle to its stops and lets go of it; scale, stops and plugs of the unit are kept,
/// and measured anew where a kind is named.
/// nudge: whether the motors have power and push the right way. stop: zero torque, whatever drove
/// the board before.
enum class DeviceAction : std::uint8_t { list, probe, home, nudge, stop };

struct DeviceCommandOptions {
    DeviceAction action = DeviceAction::list;
    std::string serial;   // of the unit; empty: the only one there is
    std::string profile;  // empty: as stored; a different kind discards what is stored for the unit
};

/// Says on `out` what was found and what to do. Without a board the error says what was looked for.
[[nodiscard]] Result<void> run_device(const DeviceCommandOptions& options, std::ostream& out);

}  // namespace touchline
