// The short sounds by name, the events at the keys and on the screen that are worth one, and which
// event gives which sound. This is the only such table, also for people (README.md is made from
// it). Threads: constant data and pure functions.
#pragma once

#include "audio-cues/synth/mixer.h"
#include "audio-cues/synth/voices.h"
#include "config/types/choices.h"
#include "config/types/contact_event.h"
#include "config/types/vec2.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace touchline {

/// In pairs of opposites; the first one rises or is brighter than the second.
enum class Cue : std::uint8_t {
    touch,  // a line is there
    leave,
    corner,  // the line turns
    end,     // the line stops
    label,   // a named spot
    cross,   // to the other side, or to another line
    finer,
    coarser,
    area_entered,
    area_left,
    key,      // a key was accepted
    refused,  // the key means nothing here
};

inline constexpr std::size_t cue_count = 12;

/// A cue at a place in the picture.
struct CueAt {
    Cue cue = Cue::touch;
    double time_s = 0.0;  // when its event occurred, since the servo started
    double pan = 0.0;     // -1 left ... 1 right
    bool is_alert = false;
};

/// Half the width and height of the drawing area.
struct CueArea {
    double half_width_m = 0.058;
    double half_height_m = 0.042;
};

/// Returns -1 at the left edge of the area ... 1 at the right one, clamped; 0 if not finite.
[[nodiscard]] double pan_of(Position place_W, const CueArea& area);

/// Events at the keys and on the screen that are worth a sound.
enum class ScreenEvent : std::uint8_t {
    key_taken,
    key_refused,    // the key means nothing here
    list_end,       // the list starts again
    picture_ready,  // another picture is felt
    picture_failed,
    label_reached,  // the hand came to a named spot
    fault,          // force went off by itself
    progress,       // work is under way
    time_out,       // is anybody there?
    shutter,        // the camera took a picture
    news,           // a stick was plugged in, or words were found
};

inline constexpr std::size_t screen_event_count = 11;

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

// Turns events into cues, and cues into commands for the mixer: pure steps.

struct CueState {
    CueAmount amount = CueAmount::cues;
    CueArea area;
    double level = 0.0;  // last rendered, to tell finer from coarser
    /// When each cue last sounded, by the servo's clock; initially before everything.
    std::array<double, cue_count> last_s = [] {
        std::array<double, cue_count> times{};
        times.fill(-1e9);
        return times;
    }();
};

struct CueStep {
    CueState state;
    std::optional<CueAt> cue;
};

/// Gives no cue if sounds are off, if the same cue sounded less than its `apart_s` ago, or if the
/// level did not change. An invalid kind gives none. O(1).
[[nodiscard]] CueStep cue_step(const CueState& state, const ContactEvent& event);

/// The same for the screen; `time_s` by the servo's clock. The cue is always in the middle.
[[nodiscard]] CueStep cue_step(const CueState& state, ScreenEvent event, double time_s);

/// Returns what the mixer plays; `frame` is when it sounds.
[[nodiscard]] MixerCommand sound_of(const CueAt& cue, FrameTime frame);

}  // namespace touchline
