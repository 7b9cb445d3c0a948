// Which screen is open, and what is said when another one is.
#include "app/session/visit_work.h"

#include <algorithm>

namespace touchline {
namespace {

void arrive(VisitWork& work) {
    work.visitor.entered_s = work.house.now_s;
    work.visitor.is_hint_due = true;
    work.visitor.repeats = 0;
}

const Language& language_of_item(const VisitWork& work, const ScreenItem& item) {
    const VisitScreen screen = open_screen(work);
    const bool is_language =
        screen == VisitScreen::language ||
        (screen == VisitScreen::values &&
         work.visitor.path.back().about == static_cast<int>(VisitItem::language));
    const auto row = static_cast<std::size_t>(item.id - static_cast<int>(VisitItem::entry));
    if (is_language && row < work.world.languages.size()) return work.world.languages[row];
    return language_of(work);
}

/// The hint of the focused item counts as said where the screen's text says it too.
void note_hint(VisitWork& work, const SpokenScreen& screen) {
    if (!screen.focus) return;
    const std::string& hint = screen.items[*screen.focus].hint;
    if (hint.empty() || screen.text.find(hint) == std::string::npos) return;
    work.visitor.hint = hint;
    work.visitor.hint_s = work.house.now_s;
}

}  // namespace

void say_item(VisitWork& work, const std::string& first) {
    const SpokenScreen screen = screen_of(work);
    if (!screen.focus) return say(work, first);
    const Language& language = language_of_item(work, screen.items[*screen.focus]);
    const std::string item = spoken_item(screen, *screen.focus, language);
    if (first.empty() || &language == &language_of(work)) {
        std::string text = first;
        add_sentence(text, item);
        return say_in(work, language, text);
    }
    say(work, first);
    say_in(work, language, item, SpeechPriority::hint);
}

void say_screen(VisitWork& work, const std::string& first) {
    const SpokenScreen screen = screen_of(work);
    std::string text = first;
    add_sentence(text, screen.title);
    add_sentence(text, screen.text);
    note_hint(work, screen);
    say_item(work, text);
}

void say_return(VisitWork& work, const std::string& first) {
    std::string text = first;
    add_sentence(text, screen_of(work).title);
    say_item(work, text);
}

void enter(VisitWork& work, VisitScreen screen, int about, std::size_t focus) {
    work.visitor.path.push_back({screen, focus, about});
    arrive(work);
}

void leave(VisitWork& work) {
    if (work.visitor.path.size() > 1) work.visitor.path.pop_back();
    arrive(work);
}

void go_to(VisitWork& work, VisitScreen screen) {
    work.visitor.path = {Standing{VisitScreen::choose}};
    if (screen != VisitScreen::choose) work.visitor.path.push_back(Standing{screen});
    arrive(work);
}

void focus_on(VisitWork& work, VisitItem item) {
    const SpokenScreen screen = screen_of(work);
    const auto found = std::find_if(
        screen.items.begin(), screen.items.end(),
        [item](const ScreenItem& shown) { return shown.id == static_cast<int>(item); });
    if (found == screen.items.end()) return;
    open_standing(work).focus = static_cast<std::size_t>(found - screen.items.begin());
}

void show_trouble(VisitWork& work, const std::string& sentence,
                  std::optional<TroubleKind> trouble) {
    const bool is_going_on = open_screen(work) == VisitScreen::trouble && trouble.has_value() &&
                             work.visitor.trouble == trouble;
    work.visitor.over = Standing{VisitScreen::trouble};
    work.visitor.error = sentence;
    work.visitor.trouble = trouble;
    work.visitor.attention_s = work.house.now_s;
    arrive(work);
    cue(work, trouble ? ScreenEvent::fault : ScreenEvent::picture_failed);
    shake(work, HandlePattern::error);
    // Who was told that something is wrong, and how to go on, hears what is new of it.
    const SpokenScreen screen = screen_of(work);
    std::string text = is_going_on ? std::string() : screen.title;
    add_sentence(text, screen.text);
    if (!is_going_on) add_sentence(text, screen.items.front().hint);
    work.visitor.is_hint_due = false;
    const bool is_safety = trouble == TroubleKind::device;
    say(work, text, is_safety ? SpeechPriority::safety : SpeechPriority::text);
}

}  // namespace touchline
