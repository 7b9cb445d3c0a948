// The handle that leads the hand, and what the hand does: its reported position, and its knob.
#include "app/session/visit_work.h"
#include "audio-cues/speech/speech_rate.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

/// Long enough for the announcement's first words, at the rate that the visitor chose.
double announcement_s(const Visitor& visitor) {
    const std::size_t rate = std::min(visitor.sound.rate, speech_rates_per_minute.size() - 1);
    return 2.0 * speech_rates_per_minute[default_speech_rate] / speech_rates_per_minute[rate];
}

bool names_parts(VisitScreen screen) {
    return screen == VisitScreen::picture || screen == VisitScreen::explore ||
           screen == VisitScreen::practice;
}

}  // namespace

void lead(VisitWork& work, const Guide& guide, const std::string& announcement) {
    if (work.site.troubles[static_cast<std::size_t>(TroubleKind::device)]) {
        refuse(work);
        return say(work, words(work, "The handle has no force now. Move it yourself."));
    }
    work.visitor.leading = Leading{guide, work.site.now_s + announcement_s(work.visitor), false};
    shake(work, HandlePattern::chosen);
    std::string text = announcement;
    add_sentence(text, words(work, has_keys(work.world) ? "Press any key to stop it."
                                                        : "Press a switch to stop it."));
    say(work, text);
}

bool stop_leading(VisitWork& work) {
    if (!work.visitor.leading) return false;
    work.visitor.leading.reset();
    order(work, Guide{});
    return true;
}

void name_part(VisitWork& work) {
    Visitor& visitor = work.visitor;
    const HandleSeen& handle = visitor.handle;
    const double rested_s = work.site.now_s - visitor.part_since_s;
    if (!handle.part) {
        if (rested_s >= 2.0) visitor.part_said.reset();
        return;
    }
    if (!visitor.felt || *handle.part >= visitor.felt->facts.parts.size()) return;
    if (visitor.over || !names_parts(visitor.path.back().screen)) return;
    if (handle.part == visitor.part_said || rested_s < dwell_s) return;
    if (handle.speed_m_per_s > quick_m_per_s) return;
    visitor.part_said = handle.part;
    cue(work, ScreenEvent::label_reached);
    const bool is_asked_for = visitor.path.back().screen == VisitScreen::explore;
    say(work, visitor.felt->facts.parts[*handle.part].name,
        is_asked_for ? SpeechPriority::text : SpeechPriority::hint);
}

void keep_what_is_touched(VisitWork& work) {
    if (work.visitor.has_touched && keep_whole(work)) tell_things(work);
}

void take(VisitWork& work, const HandleSeen& handle) {
    Visitor& visitor = work.visitor;
    if (handle.part != visitor.handle.part) visitor.part_since_s = work.site.now_s;
    visitor.handle = handle;
    visitor.has_touched = visitor.has_touched || handle.part.has_value();
    keep_what_is_touched(work);
    const bool is_hand = handle.has_moved && !handle.is_led;
    if (is_hand) visitor.active_s = work.site.now_s;
    const VisitScreen screen = open_screen(work);
    if (is_hand && screen == VisitScreen::attract) return begin_visit(work);
    if (is_hand && screen == VisitScreen::question) {
        visitor.pulled_s.reset();
        return uncover(work, words(work, "You have more time."));
    }
    name_part(work);
}

void take(VisitWork& work, const KnobTurned& knob) {
    Visitor& visitor = work.visitor;
    if (visitor.feel.shape == HeldShape::none || !std::isfinite(knob.by_rad)) return;
    visitor.active_s = work.site.now_s;
    visitor.feel.turn_rad += knob.by_rad;
}

}  // namespace touchline
