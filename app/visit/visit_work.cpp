#include "app/visit/visit_work.h"

#include <algorithm>
#include <utility>

namespace touchline {
namespace {

const Language& language_at(const VisitWorld& world, std::size_t index) {
    return world.languages[std::min(index, world.languages.size() - 1)];
}

void arrive(VisitWork& work) {
    work.visitor.entered_s = work.site.now_s;
    work.visitor.is_hint_due = true;
    work.visitor.has_moved = false;
    work.visitor.repeats = 0;
}

/// True if these words were said a moment ago and no key was pressed since. Notes them.
bool is_said_again(VisitWork& work, const std::string& language, const std::string& text) {
    constexpr double lately_s = 10.0;
    const double now_s = work.site.now_s;
    auto& said = work.visitor.said;
    std::erase_if(said, [&](const SaidLately& each) { return now_s - each.at_s >= lately_s; });
    const double key_s = work.visitor.key_s;
    const bool is_again = std::ranges::any_of(said, [&](const SaidLately& each) {
        return each.text == text && each.language == language && each.at_s >= key_s;
    });
    const bool is_asked = work.is_asked || work.is_of_hand;
    if (!is_again || is_asked) said.push_back({language, text, now_s});
    return is_again && !is_asked;
}

void keep_for_repeat(VisitWork& work, const Language& language, const SpokenText& text) {
    Caption& caption = work.visitor.caption;
    caption.text = text.words;
    caption.language = language.code();
    caption.recorded = text.recorded;
}

/// Whoever listens to a recording, which may take minutes, need not press a key.
void note_listening(VisitWork& work, const std::vector<RecordedSpan>& recorded) {
    if (recorded.empty() || !work.visitor.sound.is_speech_on) return;
    double& until_s = work.visitor.listens_until_s;
    until_s = work.site.now_s;
    for (const RecordedSpan& span : recorded) until_s += length_s(*span.recording);
}

/// Counts the hint of the focused item as said if the screen's text says it too.
void note_hint(VisitWork& work, const SpokenScreen& screen) {
    if (!screen.focus || !untold_hint(screen).empty()) return;
    const std::string& hint = screen.items[*screen.focus].hint;
    if (!hint.empty()) hint_of(work.visitor, hint).said(work.site.now_s);
}

}  // namespace

const Language& language_of(const Visit& visit, const VisitWorld& world) {
    return language_at(world, visit.visitor.sound.language);
}

const Language& language_of_item(const Visit& visit, const ScreenItem& item,
                                 const VisitWorld& world) {
    const VisitScreen screen = open_screen(visit);
    const bool is_language =
        screen == VisitScreen::language ||
        (screen == VisitScreen::values &&
         visit.visitor.path.back().about == static_cast<int>(VisitItem::language));
    const auto row = static_cast<std::size_t>(item.id - static_cast<int>(VisitItem::entry));
    if (is_language && row < world.languages.size()) return world.languages[row];
    return language_of(visit, world);
}

const Language& language_of(const VisitWork& work) {
    return language_at(work.world, work.visitor.sound.language);
}

VisitScreen open_screen(const Visit& visit) {
    return open_standing(visit.visitor).screen;
}

VisitScreen open_screen(const VisitWork& work) {
    return open_standing(work.visitor).screen;
}

const Standing& open_standing(const Visitor& visitor) {
    return visitor.over ? *visitor.over : visitor.path.back();
}

Standing& open_standing(VisitWork& work) {
    return work.visitor.over ? *work.visitor.over : work.visitor.path.back();
}

Visit visit_of(const VisitWork& work) {
    return {work.site, work.visitor};
}

SpokenScreen screen_of(const VisitWork& work) {
    return screen_of(visit_of(work), work.world);
}

void order(VisitWork& work, VisitOrder order) {
    work.orders.push_back(std::move(order));
}

void cue(VisitWork& work, ScreenEvent event) {
    work.visitor.caption.sign = event;
    order(work, GiveCue{event});
}

void shake(VisitWork& work, HandlePattern pattern) {
    order(work, GivePattern{pattern});
}

void refuse(VisitWork& work) {
    cue(work, ScreenEvent::key_refused);
    shake(work, HandlePattern::error);
}

void say_in(VisitWork& work, const Language& language, const SpokenText& text,
            SpeechPriority priority) {
    if (text.words.empty()) return;
    // A hint may wait, or never be said, so Repeat keeps what was said before it.
    if (priority != SpeechPriority::hint) keep_for_repeat(work, language, text);
    const bool is_again = is_said_again(work, language.code(), text.words);
    if (is_again && priority != SpeechPriority::safety) return;
    note_listening(work, text.recorded);
    order(work, Utterance{language.code(), text.words, priority, text.recorded, work.is_of_hand});
}

void say_again(VisitWork& work) {
    const Caption& last = work.visitor.caption;
    note_listening(work, last.recorded);
    order(work, Utterance{last.language, last.text, SpeechPriority::text, last.recorded});
}

void say_next(VisitWork& work, const SpokenText& text) {
    if (text.words.empty()) return;
    say(work, text, SpeechPriority::hint);
    keep_for_repeat(work, language_of(work), text);
}

void say(VisitWork& work, const SpokenText& text, SpeechPriority priority) {
    say_in(work, language_of(work), text, priority);
}

std::string words(const VisitWork& work, const std::string& english,
                  std::initializer_list<std::string_view> values) {
    return language_of(work).text("visit", english, values);
}

// Which screen is open, and what is said when another one opens.

HintSaid& hint_of(Visitor& visitor, const std::string& text) {
    const auto known = std::ranges::find(visitor.hints, text, &HintSaid::text);
    return known != visitor.hints.end() ? *known : visitor.hints.emplace_back(HintSaid{text});
}

std::string untold_hint(const SpokenScreen& screen) {
    if (!screen.focus) return {};
    const std::string& hint = screen.items[*screen.focus].hint;
    return screen.text.find(hint) == std::string::npos ? hint : std::string();
}

void say_item(VisitWork& work, const SpokenText& first) {
    const SpokenScreen screen = screen_of(work);
    if (!screen.focus) return say(work, first);
    const Visit visit = visit_of(work);
    const Language& language = language_of_item(visit, screen.items[*screen.focus], work.world);
    const SpokenText item = told_item(screen, *screen.focus, language);
    if (first.words.empty() || &language == &language_of(work)) {
        SpokenText text = first;
        add_sentence(text, item);
        return say_in(work, language, text);
    }
    say(work, first);
    say_in(work, language, item, SpeechPriority::hint);
}

void say_item_next(VisitWork& work, SpokenText text) {
    const SpokenScreen screen = screen_of(work);
    if (screen.focus) add_sentence(text, told_item(screen, *screen.focus, language_of(work)));
    work.visitor.is_hint_due = true;
    say_next(work, text);
}

void say_screen(VisitWork& work, const std::string& first) {
    const SpokenScreen screen = screen_of(work);
    SpokenText text(first);
    add_sentence(text, told_title(screen));
    add_sentence(text, told_text(screen));
    note_hint(work, screen);
    say_item(work, text);
}

void say_return(VisitWork& work, const std::string& first) {
    const SpokenScreen screen = screen_of(work);
    SpokenText text(first);
    add_sentence(text, {screen.title, if_short(screen.title_recording)});
    say_item(work, text);
}

void enter(VisitWork& work, VisitScreen screen, int about, std::size_t focus) {
    keep_whole(work);
    work.visitor.path.push_back({screen, focus, about});
    arrive(work);
}

void leave(VisitWork& work) {
    keep_whole(work);
    if (work.visitor.path.size() > 1) work.visitor.path.pop_back();
    arrive(work);
}

void step_back(VisitWork& work) {
    leave(work);
    const bool is_to_be_told =
        work.visitor.is_told_shortly && open_screen(work) == VisitScreen::picture;
    if (!is_to_be_told) return say_return(work);
    work.visitor.is_told_shortly = false;
    say_screen(work);
}

void go_to(VisitWork& work, VisitScreen screen) {
    keep_whole(work);
    work.visitor.path = {Standing{VisitScreen::choose}};
    if (screen != VisitScreen::choose) work.visitor.path.push_back(Standing{screen});
    arrive(work);
}

void focus_on(VisitWork& work, VisitItem item) {
    const auto place = place_of(screen_of(work).items, static_cast<int>(item));
    if (place) open_standing(work).focus = *place;
}

std::string told_trouble(TroubleKind kind, const std::string& sentence, const Language& language) {
    if (!sentence.empty()) return sentence;
    switch (kind) {
        case TroubleKind::device:
            return language.text("visit", "The handle has no force. It does not answer.") + ' ' +
                   language.text("fault", "Please call the staff.");
        case TroubleKind::sound:
            return language.text("speech", "There is no sound. Please call the staff.");
        case TroubleKind::camera:
            return language.text("visit",
                                 "The camera does not answer. Choose other pictures, or "
                                 "tell the staff.");
        case TroubleKind::stick:
            return language.text("visit",
                                 "The USB stick cannot be read. Pull it out and put it in again.");
    }
    return {};
}

void show_trouble(VisitWork& work, const std::string& sentence,
                  std::optional<TroubleKind> trouble) {
    const bool is_going_on = open_screen(work) == VisitScreen::trouble && trouble.has_value() &&
                             work.visitor.trouble == trouble;
    if (!is_going_on) work.visitor.over = Standing{VisitScreen::trouble};
    work.visitor.error = sentence;
    work.visitor.trouble = trouble;
    work.visitor.attention_s = work.site.now_s;
    arrive(work);
    cue(work, trouble ? ScreenEvent::fault : ScreenEvent::picture_failed);
    shake(work, HandlePattern::error);
    // A visitor who was told what is wrong, and how to go on, hears only the news about it.
    const SpokenScreen screen = screen_of(work);
    std::string text = is_going_on ? std::string() : screen.title;
    add_sentence(text, screen.text);
    if (!is_going_on) {
        add_sentence(text, screen.items.front().hint);
        hint_of(work.visitor, screen.items.front().hint).said(work.site.now_s);
    }
    work.visitor.is_hint_due = false;
    const bool is_safety = trouble == TroubleKind::device;
    say(work, text, is_safety ? SpeechPriority::safety : SpeechPriority::text);
}

void close_trouble(VisitWork& work, const std::string& first) {
    work.visitor.over.reset();
    work.visitor.error.clear();
    say_return(work, first);
}

void uncover(VisitWork& work, const std::string& first) {
    work.visitor.over.reset();
    if (work.visitor.error.empty()) return say_return(work, first);
    work.visitor.over = Standing{VisitScreen::trouble};
    say_screen(work, first);
}

}  // namespace touchline
