#include "app/session/visit_work.h"

#include <algorithm>
#include <utility>

namespace touchline {
namespace {

const Language& language_at(const VisitWorld& world, std::size_t index) {
    return world.languages[std::min(index, world.languages.size() - 1)];
}

}  // namespace

const Language& language_of(const Visit& visit, const VisitWorld& world) {
    return language_at(world, visit.visitor.sound.language);
}

const Language& language_of(const VisitWork& work) {
    return language_at(work.world, work.visitor.sound.language);
}

VisitScreen open_screen(const Visit& visit) {
    if (visit.visitor.over) return visit.visitor.over->screen;
    return visit.visitor.path.back().screen;
}

VisitScreen open_screen(const VisitWork& work) {
    if (work.visitor.over) return work.visitor.over->screen;
    return work.visitor.path.back().screen;
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

void say_in(VisitWork& work, const Language& language, const std::string& text,
            SpeechPriority priority) {
    if (text.empty()) return;
    // A hint may wait, or never be said, so Repeat keeps what was said before it.
    if (priority != SpeechPriority::hint) {
        work.visitor.caption.text = text;
        work.visitor.caption.language = language.code();
    }
    order(work, Utterance{language.code(), text, priority});
}

void say_next(VisitWork& work, const std::string& text) {
    if (text.empty()) return;
    say(work, text, SpeechPriority::hint);
    work.visitor.caption.text = text;
    work.visitor.caption.language = language_of(work).code();
}

void say(VisitWork& work, const std::string& text, SpeechPriority priority) {
    say_in(work, language_of(work), text, priority);
}

std::string words(const VisitWork& work, const std::string& english,
                  std::initializer_list<std::string_view> values) {
    return language_of(work).text("visit", english, values);
}

}  // namespace touchline
