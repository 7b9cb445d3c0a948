// How the picture is opened, opened again in another way, and told.
#include "app/visit/page_place.h"
#include "app/visit/visit_work.h"
#include "audio-cues/words/language.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace touchline {
namespace {

/// Opens it in the current language and detail.
void load(VisitWork& work, Loading loading) {
    loading.order.request = ++work.site.request;
    loading.order.language = work.visitor.sound.language;
    loading.order.detail = work.visitor.detail;
    order(work, loading.order);
    work.visitor.loading = std::move(loading);
}

/// Loading failed. A detail that could not be reached is given up; one that was set while something
/// else was opened applies to what is felt.
void stay_with_felt(VisitWork& work, LoadReason wanted) {
    Visitor& visitor = work.visitor;
    if (!visitor.felt) return;
    const LoadPicture& felt = visitor.felt->order;
    if (wanted == LoadReason::detail || wanted == LoadReason::unasked) {
        visitor.detail = felt.detail;
    } else if (felt.detail != visitor.detail || felt.language != visitor.sound.language) {
        open_unasked(work);
    }
}

/// Names the picture that was to be opened; a part of the one that is felt needs no name.
std::string told_failure(const VisitWork& work, const Loading& failed,
                         const std::string& sentence) {
    if (sentence.empty())
        return words(work, "This picture cannot be opened. It may be damaged. Choose another one.");
    if (failed.reason != LoadReason::other_picture || failed.name.empty()) return sentence;
    return words(work, "{0} cannot be opened.", {failed.name}) + ' ' + sentence;
}

void leave_opening(VisitWork& work) {
    if (work.visitor.path.back().screen == VisitScreen::opening) leave(work);
}

void arrive_at_picture(VisitWork& work, const Loading& done) {
    Visitor& visitor = work.visitor;
    const bool is_practice = done.order.source == PictureSource::practice;
    go_to(work, is_practice ? VisitScreen::practice : VisitScreen::picture);
    if (done.focus) focus_on(work, *done.focus);
    if (visitor.over) return say(work, told_picture(work), SpeechPriority::hint);
    const PagePlace& place = visitor.felt->facts.place;
    if (place.things != ThingSearch::under_way) return say_screen(work);
    visitor.is_told_shortly = true;
    std::string text = screen_of(work).title;
    add_sentence(text, words_of(place, language_of(work)));
    visitor.is_hint_due = false;  // nobody has heard of its item yet
    say_next(work, text);
}

bool is_of_what_was_felt(LoadReason reason) {
    return reason == LoadReason::detail || reason == LoadReason::zoom ||
           reason == LoadReason::unasked;
}

/// Notes what can be undone before something else is felt.
void note_change(Visitor& visitor, LoadReason reason) {
    if (reason == LoadReason::unasked) return;
    visitor.before.reset();
    if (reason == LoadReason::zoom) visitor.before = visitor.felt->order.zoom;
    if (reason == LoadReason::detail) visitor.before = visitor.felt->order.detail;
}

SpokenText told_change(const VisitWork& work, LoadReason reason) {
    const KnownPicture& felt = *work.visitor.felt;
    const Language& language = language_of(work);
    switch (reason) {
        case LoadReason::detail:
            return language.counted("count", "{0} outline", "{0} outlines",
                                    felt.facts.outline_count);
        case LoadReason::zoom:
            if (felt.order.zoom.factor <= 1.0) return words(work, "The whole picture.");
            return words(work, "Now {0} times as large. You feel the {1} of the picture.",
                         {language.number(felt.order.zoom.factor, 0),
                          words_of(place_of(felt.order.zoom.centre, CueArea{}), language)});
        case LoadReason::other_view: {
            // What changed comes first.
            std::string text = words_of(felt.facts.place, language);
            add_sentence(text, words_of(felt.facts.names, language));
            add_sentence(text, language.counted("count", "{0} outline", "{0} outlines",
                                                felt.facts.outline_count));
            add_sentence(text, felt.facts.note);
            return text;
        }
        case LoadReason::main_thing:
        case LoadReason::thing_here:
        case LoadReason::other_picture:
        case LoadReason::unasked:
            break;
    }
    return told_picture(work);
}

/// Adds the item of the enlargement without its value, which was told already.
void say_zoom(VisitWork& work, SpokenText text) {
    focus_on(work, VisitItem::zoom);  // other items may have come before it
    SpokenScreen screen = screen_of(work);
    screen.items[*screen.focus].value.clear();
    add_sentence(text, told_item(screen, *screen.focus, language_of(work)));
    say(work, text);
}

/// Whoever turned a page can turn on with the same key: the item keeps the focus, or the way back
/// to the picture has it. It is told without its place, a second count after that of the page.
void tell_view(VisitWork& work, std::optional<VisitItem> turned, SpokenText text) {
    focus_on(work, VisitItem::pages);
    if (turned) {
        enter(work, VisitScreen::pages);
        focus_on(work, VisitItem::back);
        focus_on(work, *turned);
    }
    const PagePlace& place = work.visitor.felt->facts.place;
    if (turned == VisitItem::next_page && place.page == place.page_count)
        add_sentence(text, words(work, "This is the last page."));
    const SpokenScreen screen = screen_of(work);
    add_sentence(text, screen.items[*screen.focus].name);
    say(work, text);
}

/// While help is open, the visitor hears it once the keys are silent. Texts that tell the whole
/// picture have its title already.
void tell_change(VisitWork& work, const Loading& done) {
    const SpokenText text = told_change(work, done.reason);
    if (work.visitor.over) return say(work, text, SpeechPriority::hint);
    switch (done.reason) {
        case LoadReason::main_thing:
            return say_item_next(work, text);
        case LoadReason::zoom:
            return say_zoom(work, text);
        case LoadReason::other_view:
            return tell_view(work, done.focus, text);
        case LoadReason::detail: {
            focus_on(work, VisitItem::detail);
            const SpokenScreen screen = screen_of(work);
            SpokenText all(screen.title, if_short(screen.title_recording));
            add_sentence(all, text);
            return say_item(work, all);
        }
        default:
            return say_item(work, text);
    }
}

/// Makes one change undone, by its kind.
struct Undo {
    VisitWork& work;

    void operator()(const ZoomWanted& zoom) const {
        LoadPicture wanted = work.visitor.felt->order;
        wanted.zoom = zoom;
        open_again(work, wanted, LoadReason::zoom);
    }

    void operator()(int detail) const { choose_detail(work, static_cast<std::size_t>(detail - 1)); }

    void operator()(Mode mode) const {
        choose_mode(work, static_cast<std::size_t>(mode));
        focus_on(work, VisitItem::mode);
        say_item(work);
    }
};

}  // namespace

SpokenText told_picture(const VisitWork& work) {
    if (!work.visitor.felt) return {};
    const PictureFacts& facts = work.visitor.felt->facts;
    SpokenText text(facts.title, facts.title_recording);
    add_sentence(text, told_text(screen_of(work)));
    return text;
}

void open_picture(VisitWork& work, PictureSource source, std::size_t index,
                  const std::string& name) {
    LoadPicture wanted;
    wanted.source = source;
    wanted.index = index;
    if (source == PictureSource::stick) wanted.form = work.visitor.stick_list->forms[index];
    load(work, {wanted, LoadReason::other_picture, name});
    leave_opening(work);
    enter(work, VisitScreen::opening);
}

void open_again(VisitWork& work, LoadPicture wanted, LoadReason reason) {
    if (!work.visitor.felt) return;
    load(work, {wanted, reason, work.visitor.felt->facts.title});
    while (work.visitor.path.back().screen != VisitScreen::picture) leave(work);
    enter(work, VisitScreen::opening);
}

void choose_detail(VisitWork& work, std::size_t value) {
    const int detail = static_cast<int>(value) + 1;
    work.visitor.detail = detail;
    const LoadPicture& felt = work.visitor.felt->order;
    if (felt.detail == detail && !work.visitor.loading) return;
    open_again(work, felt, LoadReason::detail);
}

void choose_mode(VisitWork& work, std::size_t value) {
    const auto mode = static_cast<Mode>(value);
    if (work.visitor.feel.mode == mode) return;
    work.visitor.before = std::exchange(work.visitor.feel.mode, mode);
}

void undo(VisitWork& work) {
    const FeltBefore before = *work.visitor.before;
    std::visit(Undo{work}, before);
}

void open_unasked(VisitWork& work) {
    Visitor& visitor = work.visitor;
    if (visitor.loading) {
        load(work, *visitor.loading);
    } else if (visitor.drawing) {
        feel_drawing(work);
    } else if (visitor.felt) {
        load(work, {visitor.felt->order, LoadReason::unasked, visitor.felt->facts.title});
    }
}

void cancel_loading(VisitWork& work) {
    Visitor& visitor = work.visitor;
    visitor.is_capturing = false;
    if (visitor.loading && visitor.loading->reason != LoadReason::unasked) {
        const Loading cancelled = *visitor.loading;
        visitor.loading.reset();
        order(work, CancelLoad{cancelled.order.request});
        stay_with_felt(work, cancelled.reason);
    }
    leave_opening(work);
    say_return(work, words(work, "Cancelled."));
}

void take(VisitWork& work, const PictureReady& ready) {
    Visitor& visitor = work.visitor;
    if (visitor.loading && visitor.loading->order.request == ready.request) {
        const Loading done = *visitor.loading;
        visitor.loading.reset();
        note_change(visitor, done.reason);
        visitor.felt = KnownPicture{done.order, ready.facts};
        if (done.reason != LoadReason::unasked) visitor.is_told_shortly = false;
        if (done.reason == LoadReason::thing_here) {
            visitor.felt->order.view = ready.facts.place.view;
            visitor.felt->order.thing_at.reset();
        }
        visitor.handle.part.reset();
        visitor.part_said.reset();
        visitor.has_touched = visitor.has_touched && is_of_what_was_felt(done.reason);
        if (done.reason == LoadReason::unasked) return;
        cue(work, ScreenEvent::picture_ready);
        leave_opening(work);
        if (done.reason == LoadReason::other_picture) {
            visitor.has_felt = false;
            return arrive_at_picture(work, done);
        }
        return tell_change(work, done);
    }
    if (!visitor.felt || visitor.felt->order.request != ready.request) return;
    if (visitor.drawing) {
        const PictureFocus focus(work);
        visitor.felt->facts = ready.facts;
        return;
    }
    const std::size_t known = visitor.felt->facts.parts.size();
    visitor.felt->facts = ready.facts;
    if (ready.facts.parts.size() <= known) return;
    cue(work, ScreenEvent::news);
    say(work,
        language_of(work).counted("visit", "{0} name was found in the picture.",
                                  "{0} names were found in the picture.",
                                  static_cast<int>(ready.facts.parts.size() - known)),
        SpeechPriority::hint);
}

/// Says what the things of the photograph probably are, and then the news; says nothing without
/// either. Tells a photograph in full if it was told shortly before.
void tell_names(VisitWork& work, const std::string& news = {}) {
    Visitor& visitor = work.visitor;
    const KnownPicture& felt = *visitor.felt;
    const bool is_open = !visitor.over && visitor.path.back().screen == VisitScreen::picture;
    const bool is_rest = visitor.is_told_shortly && is_open;
    SpokenText text = is_rest ? told_picture(work) : words_of(felt.facts.names, language_of(work));
    // The text of the whole picture says what was not found.
    const bool is_told = is_rest && felt.facts.place.things != ThingSearch::found;
    if (!news.empty() && !is_told) add_sentence(text, words(work, news));
    if (!is_rest) return say(work, text, SpeechPriority::hint);
    visitor.is_told_shortly = false;
    say_item_next(work, text);
}

bool keep_whole(VisitWork& work) {
    auto& loading = work.visitor.loading;
    if (!loading || loading->reason != LoadReason::main_thing) return false;
    order(work, CancelLoad{loading->order.request});
    loading.reset();
    return true;
}

void tell_things(VisitWork& work) {
    cue(work, ScreenEvent::news);
    tell_names(work, "The main subject was found. You will find it under: How much of the photo.");
}

/// If the hand has found a line, the picture stays: the visitor is told, and can choose the main
/// thing.
void take(VisitWork& work, const ThingsLookedFor& looked) {
    Visitor& visitor = work.visitor;
    if (!visitor.felt || visitor.felt->order.request != looked.request) return;
    visitor.felt->facts.place = looked.place;
    visitor.felt->facts.names = looked.names;
    visitor.felt->order.page = looked.place.page;
    visitor.felt->order.view = looked.place.view;
    if (looked.place.things == ThingSearch::impossible)
        return tell_names(work, "The main subject cannot be looked for now.");
    if (looked.place.things == ThingSearch::absent)
        return tell_names(work, "The main subject cannot be found here.");
    if (looked.place.things != ThingSearch::found)
        return tell_names(work, "No clear main subject was found.");
    const bool is_waiting = !visitor.has_touched && !visitor.loading && !visitor.is_capturing &&
                            visitor.felt->order.zoom.factor <= 1.0 &&
                            visitor.path.back().screen == VisitScreen::picture;
    if (!is_waiting) return tell_things(work);
    LoadPicture wanted = visitor.felt->order;
    wanted.view = 1;
    wanted.zoom = {};
    load(work, {wanted, LoadReason::main_thing, visitor.felt->facts.title});
}

void take(VisitWork& work, const PictureFailed& failed) {
    Visitor& visitor = work.visitor;
    if (!visitor.loading || visitor.loading->order.request != failed.request) return;
    const Loading loading = *visitor.loading;
    visitor.loading.reset();
    stay_with_felt(work, loading.reason);
    if (loading.reason == LoadReason::main_thing) return tell_names(work);
    if (loading.reason == LoadReason::unasked) return;
    leave_opening(work);
    if (loading.reason == LoadReason::thing_here) return say_return(work, failed.sentence);
    show_trouble(work, told_failure(work, loading, failed.sentence), std::nullopt);
}

}  // namespace touchline
