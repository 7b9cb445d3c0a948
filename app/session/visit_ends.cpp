// How a visit begins, and how it leaves nothing behind.
#include "app/session/visit_work.h"

#include <algorithm>
#include <utility>

namespace touchline {

Visitor new_visitor(const Site& site, const VisitWorld& world) {
    Visitor visitor;
    visitor.sound = world.rules.sound;
    visitor.sound.language = std::min(visitor.sound.language, world.languages.size() - 1);
    visitor.sound.volume = std::min(visitor.sound.volume, world.rules.volume_steps - 1);
    visitor.look = world.rules.look;
    visitor.feel.mode = world.settings.mode;
    visitor.detail = world.settings.detail;
    visitor.active_s = site.now_s;
    visitor.key_s = site.now_s;
    visitor.entered_s = site.now_s;
    if (site.opening != SiteOpening::open) visitor.path = {Standing{VisitScreen::closed}};
    return visitor;
}

/// A stick that came while nobody was here belongs to the next visitor.
void nobody_is_here(VisitWork& work) {
    Visitor before = std::move(work.visitor);
    work.visitor = new_visitor(work.site, work.world);
    work.visitor.has_stick = before.has_stick;
    work.visitor.stick_list = std::move(before.stick_list);
}

void begin_visit(VisitWork& work) {
    nobody_is_here(work);
    work.visitor.path = {{VisitScreen::language, work.visitor.sound.language, 0}};
    work.visitor.is_hint_due = true;
    say_screen(work);
}

void end_visit(VisitWork& work, VisitScreen next) {
    order(work, Hush{});
    order(work, Guide{});
    if (work.visitor.loading) order(work, CancelLoad{work.visitor.loading->order.request});
    order(work, Wipe{});
    order(work, GiveStickBack{});
    const std::size_t language = work.visitor.sound.language;
    const bool has_stick = work.visitor.has_stick;
    work.visitor = new_visitor(work.site, work.world);
    work.visitor.path = {Standing{next}};
    // The last words are still in the visitor's language.
    if (next == VisitScreen::goodbye) {
        work.visitor.sound.language = language;
        work.visitor.has_stick_to_take = has_stick;
    }
    say_screen(work);
}

}  // namespace touchline
