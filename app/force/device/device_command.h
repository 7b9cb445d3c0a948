// What touchline device is asked for. Threads: values.
#pragma once

#include <cstdint>
#include <string>

namespace touchline {

/// list: shows the boards that are plugged in. probe: tells whether one answers, and how fast.
/// home: the person leads the handle to its stops and lets go of it. This stores the scale, stops
/// and plugs of the unit, and measures them anew if a kind is named. nudge: tells whether the
/// motors have power and push the right way. stop: sets zero torque, whatever drove the board
/// before.
enum class DeviceAction : std::uint8_t { list, probe, home, nudge, stop };

struct DeviceCommandOptions {
    DeviceAction action = DeviceAction::list;
    std::string serial;   // the unit's; empty: the only one plugged in
    std::string profile;  // empty: as stored; a different kind discards what is stored for the unit
    // As the setting device.make; empty: list and stop take all, others the first.
    std::string make = {};
    std::string port = {};  // as the setting device.port
};

}  // namespace touchline
