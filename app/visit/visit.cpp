#include "app/visit/visit.h"

#include "app/documents/sticks/first_letters.h"
#include "app/documents/sticks/spoken_name.h"
#include "app/visit/told_lines.h"
#include "app/visit/visit_work.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace touchline {
namespace {

void leave_screens_of_picture(VisitWork& work) {
    if (work.visitor.path.back().screen == VisitScreen::opening) leave(work);
}

std::shared_ptr<const StickList> list_of(const std::vector<std::string>& names,
                                         const StickRest& rest, const VisitWorld& world) {
    return std::make_shared<const StickList>(
        StickList{names, rest, spoken_forms(names, world.languages), first_letters(names)});
}

/// Without a stick, the pictures that the kiosk was started with are offered.
void offer_given(Visitor& visitor, const Site& site) {
    visitor.has_stick = site.given != nullptr;
    visitor.stick_list = site.given;
}

void take(VisitWork& work, const PicturesGiven& given) {
    work.site.given = list_of(given.names, {}, work.world);
    if (!work.visitor.has_stick) offer_given(work.visitor, work.site);
}

void take(VisitWork& work, const StickArriving& /*stick*/) {
    work.visitor.has_stick = true;
    work.visitor.stick_list.reset();
    leave_parts_of_stick(work.visitor);
    if (open_screen(work) == VisitScreen::stick) say(work, screen_of(work).text);
}

void take(VisitWork& work, const StickCame& came) {
    Visitor& visitor = work.visitor;
    visitor.has_stick = true;
    visitor.stick_list = list_of(came.names, came.rest, work.world);
    leave_parts_of_stick(work.visitor);
    if (!is_visit_on(visit_of(work))) return;
    if (open_screen(work) == VisitScreen::stick) {
        cue(work, ScreenEvent::news);
        return say_item_next(work, screen_of(work).text);  // then it is being read
    }
    cue(work, ScreenEvent::news);
    say(work, words(work, "A USB stick is plugged in. You will find it under What to feel."),
        SpeechPriority::hint);
}

void take(VisitWork& work, const StickGone& gone) {
    Visitor& visitor = work.visitor;
    const bool had_stick = visitor.has_stick;
    offer_given(visitor, work.site);
    leave_parts_of_stick(work.visitor);
    if (!is_visit_on(visit_of(work))) return;
    if (!gone.sentence.empty()) return show_trouble(work, gone.sentence, TroubleKind::stick);
    if (!had_stick) return;
    cue(work, ScreenEvent::news);
    std::string told = words(work, "The USB stick is out.");
    if (visitor.felt) add_sentence(told, words(work, "Your picture stays open."));
    if (open_screen(work) != VisitScreen::stick) return say(work, told, SpeechPriority::hint);
    if (visitor.has_stick) return say_return(work, told);  // the pictures given at the start
    add_sentence(told, words(work, "Put a USB stick into the slot; nothing is written to it."));
    say_item(work, told);
}

void take(VisitWork& work, const HeadphonesChanged& change) {
    Visitor& visitor = work.visitor;
    work.site.has_headphones = change.are_in;
    const VisitScreen screen = open_screen(work);
    const bool is_idle = screen == VisitScreen::attract || screen == VisitScreen::goodbye;
    if (is_idle && change.are_in) {
        cue(work, ScreenEvent::key_taken);
        return begin_visit(work);
    }
    if (!is_visit_on(visit_of(work))) return;
    // Another output begins with its own volume. What was private is not said aloud.
    visitor.sound.volume =
        std::min(work.world.rules.sound.volume, work.world.rules.volume_steps - 1);
    visitor.active_s = work.site.now_s;
    order(work, Hush{});
    if (!change.are_in) {
        visitor.pulled_s = work.site.now_s;
        return say(work, language_of(work).text("speech", "The headphones are out."));
    }
    visitor.pulled_s.reset();
    visitor.sound.is_speech_on = true;
    const std::string told = language_of(work).text("speech", "The headphones are in.");
    screen == VisitScreen::question ? uncover(work, told) : say_return(work, told);
}

void take(VisitWork& work, const CameraCaptured& captured) {
    if (!work.visitor.is_capturing) return;
    work.visitor.is_capturing = false;
    cue(work, ScreenEvent::shutter);
    open_picture(work, PictureSource::camera, 0, {});
    say(work, words(work, captured.is_doubtful
                              ? "The photo has been taken. It is unclear; you can take it again."
                              : "The photo has been taken."));
}

void take(VisitWork& work, const CameraFailed& failed) {
    if (!work.visitor.is_capturing) return;
    work.visitor.is_capturing = false;
    leave_screens_of_picture(work);
    show_trouble(work,
                 failed.sentence.empty()
                     ? words(work, "The camera gave no photo. Try again, or tell the staff.")
                     : failed.sentence,
                 std::nullopt);
}

void take(VisitWork& work, const CameraChanged& change) {
    if (work.site.has_camera == change.is_there) return;
    work.site.has_camera = change.is_there;
    if (!change.is_there) take(work, CameraFailed{});
    if (work.visitor.path.back().screen == VisitScreen::camera) work.visitor.path.back().focus = 0;
    if (open_screen(work) == VisitScreen::camera) say_screen(work);
}

/// A sheet of a visitor who is gone is nobody's business. The others are told by and by.
void take(VisitWork& work, const SheetEnded& ended) {
    work.site.is_printing = false;
    Visitor& visitor = work.visitor;
    if (!std::exchange(visitor.awaits_sheet, false)) return;
    if (ended.end != PrintEnd::printed && ended.end != PrintEnd::not_removed) {
        visitor.failed_sheet = ended.end;
        return;
    }
    ++visitor.sheets;
    visitor.farewell.has_sheet = true;
    cue(work, ScreenEvent::news);
    visitor.sheet_news = 2;
    visitor.sheet_told_s.reset();
}

std::string told_arrival(const VisitWork& work, GuideKind kind) {
    if (kind == GuideKind::outline) {
        const std::string told = words(work, "That was the whole outline.");
        if (open_screen(work) != VisitScreen::practice) return told;
        return told + ' ' + words(work, "Now feel it on your own, choose another shape, or go on.");
    }
    if (kind == GuideKind::bring_back) return words(work, "You are on a line.");
    return language_of(work).text("guidance", "You are there.");
}

std::string told_end(const VisitWork& work, GuidanceEnd why, GuideKind kind) {
    switch (why) {
        case GuidanceEnd::arrived:
            return told_arrival(work, kind);
        case GuidanceEnd::let_go:
            return words(work, "You let go of the handle. It has stopped guiding you.");
        case GuidanceEnd::no_force:
            return words(work, "The force is off. The handle has stopped guiding you.");
        case GuidanceEnd::other:
            break;
    }
    return words(work, "The handle has stopped guiding you.");
}

void take(VisitWork& work, const GuidanceEnded& ended) {
    auto& leading = work.visitor.leading;
    if (!leading || !leading->has_begun) return;
    const GuideKind kind = leading->guide.kind;
    leading.reset();
    work.visitor.active_s = work.site.now_s;
    if (ended.why == GuidanceEnd::arrived) {
        if (kind == GuideKind::outline) note_felt(work.visitor);
        cue(work, ScreenEvent::label_reached);
        shake(work, HandlePattern::chosen);
    }
    const std::string told = told_end(work, ended.why, kind);
    // Whoever has just chosen a part knows where in the list it is. A near one is reached while it
    // is still announced.
    if (ended.why == GuidanceEnd::arrived && kind == GuideKind::to_place)
        return say_next(work, told);
    say_item_next(work, told);
}

void take(VisitWork& work, const TroubleBegan& began) {
    auto& known = work.site.troubles[static_cast<std::size_t>(began.kind)];
    if (known == began.sentence) return;
    known = began.sentence;
    if (!is_visit_on(visit_of(work))) return;
    std::string told;
    if (began.kind == TroubleKind::device && stop_leading(work))
        told = words(work, "Guiding has stopped.");
    add_sentence(told, told_trouble(began.kind, began.sentence, language_of(work)));
    show_trouble(work, told, began.kind);
}

void take(VisitWork& work, const TroubleEnded& ended) {
    const TroubleKind kind = ended.kind;
    auto& known = work.site.troubles[static_cast<std::size_t>(kind)];
    if (!known) return;
    known.reset();
    Visitor& visitor = work.visitor;
    if (!is_visit_on(visit_of(work))) return;
    const std::string told =
        words(work, kind == TroubleKind::device ? "The force is back." : "It works again.");
    if (open_screen(work) != VisitScreen::trouble || visitor.trouble != kind)
        return say_next(work, told);  // Repeat says it too, and no longer the trouble
    close_trouble(work, told);
}

void take(VisitWork& work, const OpeningChanged& change) {
    if (work.site.opening == change.opening) return;
    work.site.opening = change.opening;
    if (is_visit_on(visit_of(work))) return end_visit(work, VisitScreen::closed);
    nobody_is_here(work);
}

void take(VisitWork& work, const StaffCalledOff& /*called_off*/) {
    if (!work.site.is_staff_called) return;
    work.site.is_staff_called = false;
    order(work, CallStaff{false});
    if (!is_visit_on(visit_of(work))) return;
    say(work, words(work, "The staff know of your call."), SpeechPriority::hint);
}

void take(VisitWork& work, const QuitAsked& /*asked*/) {
    stop_leading(work);
    work.visitor.over = Standing{VisitScreen::confirm, 0, static_cast<int>(VisitItem::quit)};
    work.visitor.entered_s = work.visitor.active_s = work.site.now_s;
    cue(work, ScreenEvent::key_taken);
    say_screen(work);
}

bool is_waited_for(const Visitor& visitor) {
    const VisitScreen screen = visitor.path.back().screen;
    const bool is_listing =
        screen == VisitScreen::stick && visitor.has_stick && !visitor.stick_list;
    return screen == VisitScreen::opening || is_listing;
}

bool wants_preview(const Visit& visit) {
    return visit.visitor.path.back().screen == VisitScreen::camera && visit.site.has_camera;
}

/// True if the visitor turns speech off: then they hear how it comes back, and nothing after that.
bool goes_silent(const Visit& before, const Visit& after) {
    return before.visitor.sound.is_speech_on && !after.visitor.sound.is_speech_on;
}

template <class... Act>
bool is_one_of(const VisitEvent& event) {
    return (std::holds_alternative<Act>(event) || ...);
}

/// What a visitor does and hears an answer to. A hand that moves hears the names of parts alone.
bool is_act(const VisitEvent& event) {
    return is_one_of<KeyPressed, KeyHeld, SpeechKeyPressed, DeadKeyPressed, HeadphonesChanged,
                     StickArriving, StickCame, StickGone, QuitAsked, PenStroke, StrokeLost,
                     DrawerKeyPressed>(event);
}

/// The orders that follow from the state alone; they come before what the step said and did.
VisitOrders changes(const Visit& before, const Visit& after) {
    VisitOrders orders;
    const bool is_same_sound = before.visitor.sound == after.visitor.sound;
    if (!is_same_sound && !goes_silent(before, after)) orders.push_back(after.visitor.sound);
    if (!(before.visitor.look == after.visitor.look)) orders.push_back(after.visitor.look);
    if (!(before.visitor.feel == after.visitor.feel)) orders.push_back(after.visitor.feel);
    if (wants_preview(before) != wants_preview(after)) {
        orders.push_back(CameraPreview{wants_preview(after)});
    }
    return orders;
}

VisitStep finish(const Visit& before, VisitWork work) {
    Visitor& visitor = work.visitor;
    visitor.feel.is_force_wanted = visitor.felt.has_value();
    if (!work.world.settings.offers_shapes) visitor.feel.shape = HeldShape::none;
    if (!visitor.felt || visitor.felt->order.source != PictureSource::drawing)
        visitor.drawing.reset();
    visitor.is_erasing = visitor.is_erasing && visitor.drawing != nullptr;
    if (!is_waited_for(visitor)) {
        visitor.waiting.reset();
    } else if (!visitor.waiting) {
        const double now_s = work.site.now_s;
        visitor.waiting = Waiting{now_s, now_s, now_s};
    }
    Visit after{std::move(work.site), std::move(visitor)};
    VisitOrders orders = changes(before, after);
    orders.insert(orders.end(), std::make_move_iterator(work.orders.begin()),
                  std::make_move_iterator(work.orders.end()));
    if (goes_silent(before, after)) orders.push_back(after.visitor.sound);
    return {std::move(after), std::move(orders)};
}

}  // namespace

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
    offer_given(visitor, site);
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
    const bool is_given = work.site.given && work.visitor.stick_list == work.site.given;
    Farewell farewell = work.visitor.farewell;
    farewell.has_stick = work.visitor.has_stick && !is_given;
    farewell.awaits_sheet = work.visitor.awaits_sheet;
    farewell.failed_sheet = work.visitor.failed_sheet;
    farewell.felt_count = static_cast<int>(work.visitor.pictures_felt.size());
    work.visitor = new_visitor(work.site, work.world);
    work.visitor.path = {Standing{next}};
    // The last words are still in the visitor's language.
    if (next == VisitScreen::goodbye) {
        work.visitor.sound.language = language;
        work.visitor.farewell = farewell;
    }
    say_screen(work);
}

VisitStep start_visit(const VisitWorld& world) {
    Visit visit;
    visit.visitor = new_visitor(visit.site, world);
    const Visitor& visitor = visit.visitor;
    return {visit, {visitor.sound, visitor.look, visitor.feel, CameraPreview{false}}};
}

VisitStep step(const Visit& visit, const VisitEvent& event, const VisitWorld& world) {
    VisitWork work{visit.site, visit.visitor, world, {}, is_act(event)};
    std::visit([&work](const auto& each) { take(work, each); }, event);
    return finish(visit, std::move(work));
}

bool is_visit_on(const Visit& visit) {
    const VisitScreen screen = visit.visitor.path.back().screen;
    return screen != VisitScreen::attract && screen != VisitScreen::goodbye &&
           screen != VisitScreen::closed;
}

}  // namespace touchline
