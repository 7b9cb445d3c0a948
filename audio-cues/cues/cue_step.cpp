#include "audio-cues/cues/cue_step.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

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
