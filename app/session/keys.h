// What each key of the kiosk does: the one table from which the session, the help overlay and the
// README are made.
// Threads: constant data and pure functions.
#pragma once

#include "config/types/key.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace touchline {

enum class Action : std::uint8_t {
    next_picture,
    previous_picture,
    next_view,
    previous_view,
    next_page,
    previous_page,
    set_detail,  // argument 0 ... 4: detail 1 ... 5
    toggle_level_automatic,
    coarser_level,
    finer_level,
    firmer,
    softer,
    next_mode,
    toggle_pop_through,
    toggle_force,
    emergency_stop,
    clear_fault,
    keep_recording,
    home_again,
    toggle_boxes,
    toggle_keys,
    next_sounds,
    toggle_speech,
    repeat_speech,
    stop_speech,
    pause_speech,
    slower_speech,
    faster_speech,
    softer_sound,
    louder_sound,
    next_language,
    headphones_in,
    headphones_out,
    quit,
};

/// One row of the table: the keys `first` ... `last` (neighbours) do `action`.
struct KeyRow {
    Key first;
    Key last;
    Action action;
    std::string_view name;   // as printed on the keys
    std::string_view words;  // what they do
};

[[nodiscard]] std::span<const KeyRow> key_table();

struct KeyAction {
    Action action;
    int argument = 0;  // which of the row's keys, from 0
};

/// Nothing for a key without a meaning.
[[nodiscard]] std::optional<KeyAction> action_of(Key key);

/// The table as Markdown, for the README; ends with a newline.
[[nodiscard]] std::string keys_as_markdown();

}  // namespace touchline
