#include "audio-cues/cues/cue_table.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr Note held(double pitch_Hz, double length, Timbre timbre = Timbre::pure) {
    return {pitch_Hz, pitch_Hz, length, 1.0, 0.0, timbre};
}

constexpr Note glide(double from_Hz, double to_Hz, double length) {
    return {from_Hz, to_Hz, length, 1.0, 0.0, Timbre::pure};
}

constexpr Note struck(double pitch_Hz, double length, double decay, Timbre timbre) {
    return {pitch_Hz, pitch_Hz, length, 1.0, decay, timbre};
}

constexpr Earcon one(const Note& note) {
    return {{note, {}, {}}, 1};
}

constexpr Earcon two(const Note& first, const Note& second) {
    return {{first, second, {}}, 2};
}

const std::array<CueRow, cue_count> cues{{
    {Cue::touch, "touch", "a knock", one(struck(880.0, 0.06, 0.015, Timbre::hollow)), 0.6, 0.05},
    {Cue::leave, "leave", "a lower, softer knock", one(struck(440.0, 0.06, 0.02, Timbre::hollow)),
     0.4, 0.05},
    {Cue::corner, "corner", "a bright tick", one(struck(1760.0, 0.05, 0.012, Timbre::bright)), 0.5,
     0.05},
    {Cue::end, "end", "a dull thud", one(struck(165.0, 0.12, 0.04, Timbre::bright)), 0.8, 0.2},
    {Cue::label, "label", "a small bell", one(struck(1320.0, 0.22, 0.08, Timbre::bright)), 0.5,
     0.3},
    {Cue::cross, "cross", "a double tick",
     two(struck(1175.0, 0.03, 0.01, Timbre::hollow), struck(1175.0, 0.03, 0.01, Timbre::hollow)),
     0.4, 0.08},
    {Cue::finer, "finer", "a quick slide up", one(glide(500.0, 900.0, 0.12)), 0.25, 0.3},
    {Cue::coarser, "coarser", "a quick slide down", one(glide(900.0, 500.0, 0.12)), 0.25, 0.3},
    {Cue::area_entered, "area entered", "two notes up", two(held(392.0, 0.08), held(523.0, 0.12)),
     0.4, 0.5},
    {Cue::area_left, "area left", "two notes down", two(held(523.0, 0.08), held(392.0, 0.12)), 0.5,
     0.5},
    {Cue::key, "key", "a short high tick", one(struck(2093.0, 0.03, 0.008, Timbre::pure)), 0.4,
     0.0},
    {Cue::refused, "refused", "a short low buzz", one(held(147.0, 0.15, Timbre::hollow)), 0.5, 0.0},
}};

constexpr std::array contacts{
    EventRow{"the hand touches a line", Cue::touch},
    EventRow{"it leaves the line", Cue::leave},
    EventRow{"it passes a corner or a junction", Cue::corner},
    EventRow{"it crosses a line", Cue::cross},
    EventRow{"it comes to the end of a line", Cue::end},
    EventRow{"the level changes: finer or coarser", std::nullopt},
    EventRow{"it goes from one outline to another", Cue::cross},
    EventRow{"it comes back into the picture", Cue::area_entered},
    EventRow{"it leaves the picture", Cue::area_left},
    EventRow{"it breaks through a wall that gave way", Cue::cross},
};

constexpr std::array<EventRow, screen_event_count> screens{{
    {"a key is taken", Cue::key},
    {"a key means nothing here", Cue::refused},
    {"a list begins anew", Cue::area_left},
    {"another picture is felt", Cue::area_entered},
    {"a picture cannot be opened", Cue::refused},
    {"the hand comes to a named spot", Cue::label},
    {"force goes off by itself", Cue::refused, true},
    {"work is under way", Cue::touch},
    {"the kiosk asks whether anybody is there", Cue::end, true},
    {"the camera takes a picture", Cue::cross, true},
    {"a stick comes, or words are found", Cue::label},
}};

/// Decides whether `cue` sounds at `at.time_s`, and remembers it.
CueStep sounded(CueState state, const CueAt& at) {
    if (state.amount == CueAmount::none && !at.is_alert) return {state, std::nullopt};
    double& last_s = state.last_s[static_cast<std::size_t>(at.cue)];
    // A restarted clock is before the last time; then the cue sounds.
    const double since_s = at.time_s - last_s;
    if (since_s >= 0.0 && since_s < row_of(at.cue).apart_s) return {state, std::nullopt};
    last_s = at.time_s;
    return {state, at};
}

}  // namespace

std::span<const CueRow> cue_table() {
    return cues;
}

const CueRow& row_of(Cue cue) {
    return cues[static_cast<std::size_t>(cue)];
}

std::span<const EventRow> contact_rows() {
    return contacts;
}

std::span<const EventRow> screen_rows() {
    return screens;
}

double pan_of(Position place_W, const CueArea& area) {
    const double pan = place_W.x / area.half_width_m;
    return std::isfinite(pan) ? std::clamp(pan, -1.0, 1.0) : 0.0;
}

CueStep cue_step(const CueState& state, const ContactEvent& event) {
    const auto kind = static_cast<std::size_t>(event.kind);
    if (kind >= contact_rows().size()) return {state, std::nullopt};
    std::optional<Cue> cue = contact_rows()[kind].cue;
    CueState next = state;
    if (event.kind == ContactEventKind::level_changed) {
        if (event.level < state.level) cue = Cue::finer;
        if (event.level > state.level) cue = Cue::coarser;
        next.level = event.level;
    }
    if (!cue) return {next, std::nullopt};
    return sounded(next, {*cue, event.time_s, pan_of(event.place_W, state.area), false});
}

CueStep cue_step(const CueState& state, ScreenEvent event, double time_s) {
    const auto kind = static_cast<std::size_t>(event);
    if (kind >= screen_rows().size()) return {state, std::nullopt};
    const EventRow& row = screen_rows()[kind];
    return sounded(state, {*row.cue, time_s, 0.0, row.is_alert});
}

MixerCommand sound_of(const CueAt& cue, FrameTime frame) {
    const CueRow& row = row_of(cue.cue);
    return {frame, PlayEarcon{row.earcon, row.level, cue.pan, cue.is_alert}};
}

}  // namespace touchline
