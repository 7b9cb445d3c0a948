// What the keys of a full keyboard do beside the six roles (config/settings/keys.h), for the staff.
// The kiosk and the README are made from this one table.
// Threads: constant data and pure functions.
#pragma once

#include "config/settings/keys.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace touchline {

enum class Action : std::uint8_t {
    repeat_speech,
    pause_speech,
    slower_speech,
    faster_speech,
    emergency_stop,
    clear_fault,
    hold_recording,
    home_again,
    toggle_live_view,
    toggle_boxes,
    erase_line,
    undo_line,
    redo_line,
    headphones_in,
    headphones_out,
    quit,
};

struct KeyRow {
    Key key;
    Action action;
    std::string_view name;   // as printed on the key
    std::string_view words;  // what it does
};

[[nodiscard]] std::span<const KeyRow> key_table();

/// Returns nothing for a key without a meaning.
[[nodiscard]] std::optional<Action> action_of(Key key);

/// True for what can start a force, keep a recording, or end the kiosk. Visitors can stop and never
/// start: once the site has a PIN, these actions need the operator's own keyboard, or the PIN on
/// the six keys.
[[nodiscard]] constexpr bool is_for_operator(Action action) {
    return action == Action::clear_fault || action == Action::home_again ||
           action == Action::hold_recording || action == Action::quit;
}

}  // namespace touchline
