// What happens without a key: what time causes, the handle that leads, and the hand that moves it.
#include "app/visit/told_lines.h"
#include "app/visit/visit_work.h"
#include "audio-cues/speech/speech_input.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace touchline {
namespace {

constexpr double hint_after_s = 1.5;
constexpr double quiet_after_s = 4.0;   // longer than an item that somebody listens to on the way
constexpr double heard_after_s = 15.0;  // words that were said before it are over
constexpr double hint_again_s = 30.0;   // the same hint: 10 s, and the time of other words
constexpr double progress_after_s = 0.3;
constexpr double progress_said_after_s = 2.0;
constexpr double progress_said_every_s = 10.5;
constexpr double private_s = 10.0;  // headphones are out; then the kiosk asks
constexpr double goodbye_s = 10.0;
constexpr double practice_s = 60.0;
constexpr double quit_asked_s = 30.0;     // then no visitor can answer it
constexpr double longest_lead_s = 300.0;  // longer leading no longer counts as presence
constexpr double dwell_s = 0.4;
constexpr double invite_every_s = 11.0;  // who comes near hears it within twelve
constexpr double quick_m_per_s = 0.08;   // no part is named while the hand is faster
constexpr double attention_every_s = 5.0;

void ask(VisitWork& work) {
    Visitor& visitor = work.visitor;
    visitor.over = Standing{VisitScreen::question};
    visitor.question_s = work.site.now_s;
    visitor.attention_s = work.site.now_s;
    visitor.pulled_s.reset();
    cue(work, ScreenEvent::time_out);
    shake(work, HandlePattern::time_out);
    say_screen(work);
}

/// A visitor who waits for work, listens to a recording, or is led, counts as present. A handle
/// that waits for a hand tells nothing.
bool is_busy(const VisitWork& work) {
    const Visitor& visitor = work.visitor;
    const double now_s = work.site.now_s;
    if (now_s < visitor.listens_until_s) return true;
    if (visitor.waiting && now_s - visitor.waiting->since_s < longest_lead_s) return true;
    return visitor.leading && visitor.handle.is_led &&
           now_s - visitor.leading->begin_s < longest_lead_s;
}

void mind_presence(VisitWork& work) {
    Visitor& visitor = work.visitor;
    const double now_s = work.site.now_s;
    if (open_screen(work) == VisitScreen::question) {
        if (now_s - visitor.question_s >= answer_s(work.world.rules)) {
            visitor.farewell.is_unanswered = true;
            return end_visit(work, VisitScreen::goodbye);
        }
        if (now_s - visitor.attention_s >= attention_every_s) {
            visitor.attention_s = now_s;
            cue(work, ScreenEvent::time_out);
            shake(work, HandlePattern::time_out);
        }
        return;
    }
    if (visitor.pulled_s && now_s - *visitor.pulled_s >= private_s) return ask(work);
    if (is_busy(work)) visitor.active_s = now_s;
    const double inactivity_s = std::clamp(work.world.rules.inactivity_s, 30.0, 1800.0);
    if (now_s - visitor.active_s >= inactivity_s) ask(work);
}

void tell_progress(VisitWork& work) {
    if (!work.visitor.waiting) return;
    Waiting& waiting = *work.visitor.waiting;
    const double now_s = work.site.now_s;
    if (now_s - waiting.since_s < progress_after_s) return;
    if (now_s - waiting.last_cue_s >= 1.0 || waiting.last_cue_s == waiting.since_s) {
        waiting.last_cue_s = now_s;
        cue(work, ScreenEvent::progress);
    }
    // A list that is being read said so when it was opened.
    const bool is_first = waiting.last_said_s == waiting.since_s;
    const bool is_new = is_first && open_screen(work) == VisitScreen::opening;
    const double after_s = is_new ? progress_said_after_s : progress_said_every_s;
    if (now_s - waiting.last_said_s < after_s) return;
    waiting.last_said_s = now_s;
    const SpokenScreen screen = screen_of(work);
    std::string text = screen.title;
    add_sentence(text, screen.text);
    say(work, text, SpeechPriority::hint);
}

const char* way_to_language(const VisitWorld& world) {
    return has_keys(world) ? "{0}: Down until you hear it, then Select."
                           : "{0}: move on until you hear it, then select.";
}

/// Says each language in itself, except the one in which everything was said already.
void say_languages(VisitWork& work) {
    const std::string how = way_to_language(work.world);
    for (const Language& language : work.world.languages) {
        if (&language == &language_of(work)) continue;
        say_in(work, language, language.text("visit", how, {language.name()}),
               SpeechPriority::hint);
    }
}

/// It waits for what is being said, and a key may cut both off: then it is told once more. One that
/// failed covers no trouble of the handle, no question and no help.
void tell_of_sheet(VisitWork& work) {
    Visitor& visitor = work.visitor;
    const double now_s = work.site.now_s;
    if (visitor.leading || work.world.rules.is_operator_in) return;
    const bool is_quiet = now_s - visitor.key_s >= quiet_after_s;
    if (visitor.failed_sheet && is_quiet && !visitor.over) return show_failed_sheet(work);
    if (visitor.sheet_news == 0) return;
    const bool is_cut_off = visitor.sheet_told_s && visitor.key_s > *visitor.sheet_told_s;
    if (visitor.sheet_told_s && !is_cut_off) {
        if (now_s - *visitor.sheet_told_s > heard_after_s) visitor.sheet_news = 0;
        return;
    }
    if (!is_quiet) return;
    --visitor.sheet_news;
    visitor.sheet_told_s = now_s;
    say_next(work, words(work, "Your sheet is in the printer."));  // Repeat says it too
}

/// A hint that was said a moment ago stays due until it is worth hearing again.
void give_hint(VisitWork& work) {
    Visitor& visitor = work.visitor;
    const double now_s = work.site.now_s;
    const double still_since_s = std::max(visitor.key_s, visitor.entered_s);
    if (!visitor.is_hint_due || now_s - still_since_s < hint_after_s) return;
    if (visitor.leading) return;                            // every key would only stop the handle
    if (open_screen(work) == VisitScreen::opening) return;  // nobody has heard of it yet
    const bool is_of_languages = open_screen(work) == VisitScreen::language;
    const SpokenScreen screen = screen_of(work);
    std::string hint;
    // The list is the same, whatever language has the focus. One that moves by itself says each.
    if (is_of_languages)
        hint = moves_by_itself(work.world) ? "" : work.world.languages.front().name();
    else if (screen.focus)
        hint = screen.items[*screen.focus].hint;
    visitor.is_hint_due = false;
    if (hint.empty()) return;
    HintSaid& known = hint_of(visitor, hint);
    if (known.is_known()) return;
    visitor.is_hint_due = known.times > 0 && now_s - known.at_s < hint_again_s;
    if (visitor.is_hint_due) return;
    known.said(now_s);
    if (!is_of_languages) return say(work, hint, SpeechPriority::hint);
    known.learn();  // all at once
    say_languages(work);
}

void begin_leading(VisitWork& work) {
    auto& leading = work.visitor.leading;
    if (!leading || leading->has_begun || work.site.now_s < leading->begin_s) return;
    leading->has_begun = true;
    order(work, leading->guide);
}

void mind_practice(VisitWork& work) {
    Standing& open = work.visitor.path.back();
    const bool is_told = open.about != 0;
    if (open.screen != VisitScreen::practice || is_told) return;
    if (!work.visitor.has_felt || work.visitor.leading) return;
    if (work.site.now_s - work.visitor.entered_s < practice_s) return;
    open.about = 1;
    say(work, words(work, "This is enough for practice. Press Back for the pictures."),
        SpeechPriority::hint);
}

/// Nobody can hear that the sound is gone, so the handle signals it, again and again.
void ask_for_attention(VisitWork& work) {
    Visitor& visitor = work.visitor;
    const bool is_mute =
        open_screen(work) == VisitScreen::trouble && visitor.trouble == TroubleKind::sound;
    if (!is_mute || work.site.now_s - visitor.attention_s < attention_every_s) return;
    visitor.attention_s = work.site.now_s;
    shake(work, HandlePattern::error);
}

/// Long enough for the announcement's first words, at the rate that the visitor chose.
double announcement_s(const Visitor& visitor) {
    const std::size_t rate = std::min(visitor.sound.rate, speech_rates_per_minute.size() - 1);
    return 2.0 * speech_rates_per_minute[default_speech_rate] / speech_rates_per_minute[rate];
}

bool names_parts(VisitScreen screen) {
    return screen == VisitScreen::picture || screen == VisitScreen::explore ||
           screen == VisitScreen::practice;
}

/// Says the name of the part that the hand rests on. It waits for a motion: a bare name after a
/// screen's words would be taken for one of its items.
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
    if (!visitor.has_moved) return;
    if (handle.part == visitor.part_said || rested_s < dwell_s) return;
    if (handle.speed_m_per_s > quick_m_per_s) return;
    visitor.part_said = handle.part;
    cue(work, ScreenEvent::label_reached);
    const bool is_asked_for = visitor.path.back().screen == VisitScreen::explore;
    const PartFacts& part = visitor.felt->facts.parts[*handle.part];
    work.is_of_hand = true;
    say(work, {part.name, part.recording},
        is_asked_for ? SpeechPriority::text : SpeechPriority::hint);
    work.is_of_hand = false;
}

/// True if the hand is on a line, as far as is known: without named parts no line is told.
bool is_on_line(const Visitor& visitor) {
    return visitor.handle.part || (visitor.felt && visitor.felt->facts.parts.empty());
}

/// The operator's question was not answered. What it was asked over may be a screen without a
/// visitor, where no other screen may stay open either.
void forget_to_quit(VisitWork& work) {
    Visitor& visitor = work.visitor;
    if (!visitor.over || work.site.now_s - visitor.entered_s < quit_asked_s) return;
    const bool is_on = is_visit_on(visit_of(work));
    if (is_on && visitor.over->screen == VisitScreen::confirm) return uncover(work);
    if (!is_on) visitor.over.reset();
}

/// Says what this is and how to begin, in one language after the other.
void invite(VisitWork& work) {
    Site& site = work.site;
    if (!work.world.rules.invites || open_screen(work) != VisitScreen::attract) return;
    if (site.now_s - site.invited_s < invite_every_s) return;
    site.invited_s = site.now_s;
    const std::vector<Language>& languages = work.world.languages;
    const Language& language = languages[site.invitations++ % languages.size()];
    std::string text = language.text("visit", "Pictures to feel");
    add_sentence(text, language.text("visit", way_to_begin(work.world)));
    say_in(work, language, text, SpeechPriority::hint);
}

}  // namespace

void take(VisitWork& work, const Tick& tick) {
    Visitor& visitor = work.visitor;
    // Events before the first tick count as happening now.
    if (work.site.now_s == 0.0) visitor.active_s = visitor.key_s = visitor.entered_s = tick.now_s;
    work.site.now_s = std::max(work.site.now_s, tick.now_s);
    const VisitScreen screen = open_screen(work);
    if (screen == VisitScreen::goodbye && work.site.now_s - work.visitor.entered_s >= goodbye_s) {
        nobody_is_here(work);
    }
    forget_to_quit(work);
    if (!is_visit_on(visit_of(work))) return invite(work);
    begin_leading(work);
    tell_progress(work);
    tell_of_sheet(work);
    give_hint(work);
    name_part(work);
    mind_practice(work);
    ask_for_attention(work);
    mind_presence(work);
}

void show_failed_sheet(VisitWork& work) {
    const PrintEnd end = *std::exchange(work.visitor.failed_sheet, {});
    show_trouble(work, told_of_print(end, language_of(work)), std::nullopt);
}

double answer_s(const VisitRules& rules) {
    return std::max(rules.answer_s, 30.0);
}

const char* way_to_begin(const VisitWorld& world) {
    return has_keys(world) ? "Hold the handle, or press any key."
                           : "Hold the handle, or press a switch.";
}

void note_felt(Visitor& visitor) {
    if (!visitor.felt || visitor.has_felt) return;
    visitor.has_felt = true;
    const LoadPicture& picture = visitor.felt->order;
    if (picture.source == PictureSource::practice) return;
    const std::pair known{picture.source, picture.index};
    // Each photo is another picture.
    const bool is_known =
        picture.source != PictureSource::camera &&
        std::ranges::find(visitor.pictures_felt, known) != visitor.pictures_felt.end();
    if (!is_known) visitor.pictures_felt.push_back(known);
}

bool has_force(const Site& site) {
    return !site.troubles[static_cast<std::size_t>(TroubleKind::device)];
}

void lead(VisitWork& work, const Guide& guide, const std::string& announcement) {
    if (!has_force(work.site)) {
        refuse(work);
        return say(work, words(work, no_force_words));
    }
    work.visitor.leading = Leading{guide, work.site.now_s + announcement_s(work.visitor), false};
    shake(work, HandlePattern::chosen);
    std::string text = announcement;
    add_sentence(text, words(work, has_keys(work.world) ? "Press any key to stop it."
                                                        : "Press your switch to stop it."));
    say(work, text);
}

bool stop_leading(VisitWork& work) {
    if (!work.visitor.leading) return false;
    work.visitor.leading.reset();
    order(work, Guide{});
    return true;
}

namespace {

/// Somebody is there, though no key was pressed: the visit goes on. Returns true if that answered
/// the question.
bool keep_visit(VisitWork& work) {
    work.visitor.active_s = work.site.now_s;
    if (open_screen(work) != VisitScreen::question) return false;
    work.visitor.pulled_s.reset();
    uncover(work, words(work, "You have more time."));
    return true;
}

}  // namespace

void take(VisitWork& work, const HandleSeen& handle) {
    Visitor& visitor = work.visitor;
    if (handle.part != visitor.handle.part) visitor.part_since_s = work.site.now_s;
    visitor.handle = handle;
    visitor.has_moved = visitor.has_moved || handle.has_moved || handle.is_led;
    visitor.has_touched = visitor.has_touched || handle.part.has_value();
    if (visitor.has_touched && keep_whole(work)) tell_things(work);
    const bool is_hand = handle.has_moved && !handle.is_led;
    if (is_hand && is_on_line(visitor)) note_felt(visitor);
    if (is_hand && open_screen(work) == VisitScreen::attract) return begin_visit(work);
    if (is_hand && keep_visit(work)) return;
    name_part(work);
}

void take(VisitWork& work, const LineRead& read) {
    if (!is_visit_on(visit_of(work))) return;
    if (keep_visit(work) || !read.is_at_end) return;
    cue(work, ScreenEvent::list_end);
    shake(work, HandlePattern::edge);
}

void take(VisitWork& work, const KnobTurned& knob) {
    Visitor& visitor = work.visitor;
    if (visitor.feel.shape == HeldShape::none || !std::isfinite(knob.by_rad)) return;
    visitor.active_s = work.site.now_s;
    visitor.feel.turn_rad += knob.by_rad;
}

}  // namespace touchline
