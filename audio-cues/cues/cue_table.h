// Which event gives which sound. This is the only such table, also for people (README.md is made
// from it).
// Threads: constant data and pure functions.
#pragma once

#include "audio-cues/cues/cue.h"
#include "audio-cues/cues/screen_event.h"
#include "audio-cues/synth/earcon.h"
#include "config/types/contact_event.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace touchline {

/// How a cue sounds, and the words in which an operator finds it.
struct CueRow {
    Cue cue;
    std::string_view name;
    std::string_view sound;  // description
    Earcon earcon;           // at most 0.25 s
    double level;            // 0 ... 1
    double apart_s;          // earliest time after which the same cue sounds again
};

/// Returns the rows in the order of Cue.
[[nodiscard]] std::span<const CueRow> cue_table();

[[nodiscard]] const CueRow& row_of(Cue cue);

/// An event of the hand or of the screen, in words, and its cue.
struct EventRow {
    std::string_view event;
    std::optional<Cue> cue;  // none: its sound depends on more (a level: finer or coarser)
    bool is_alert = false;   // sounds even if sounds are off
};

/// Returns the rows in the order of ContactEventKind.
[[nodiscard]] std::span<const EventRow> contact_rows();

/// Returns the rows in the order of ScreenEvent.
[[nodiscard]] std::span<const EventRow> screen_rows();

/// Returns both tables as Markdown, for the README; ends with a newline.
[[nodiscard]] std::string cues_as_markdown();

}  // namespace touchline
