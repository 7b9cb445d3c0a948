// What Select does, item by item.
#include "app/session/visit_work.h"

#include <algorithm>

namespace touchline {
namespace {

void refuse(VisitWork& work, const std::string& why) {
    cue(work, ScreenEvent::key_refused);
    shake(work, HandlePattern::error);
    say(work, why);
}

void open(VisitWork& work, VisitScreen screen, int about = 0, std::size_t focus = 0) {
    enter(work, screen, about, focus);
    say_screen(work);
}

void open_values(VisitWork& work, VisitItem setting) {
    const ValueList list = values_of(visit_of(work), work.world, setting);
    open(work, VisitScreen::values, static_cast<int>(setting), list.chosen);
}

void turn_page(VisitWork& work, int change) {
    Standing& open = open_standing(work);
    open.about = std::max(open.about + change * list_page, 0);
    open.focus = 0;
    say_screen(work);
}

void step_view(VisitWork& work, VisitItem item) {
    const PagePlace place = work.visitor.felt->facts.place;
    LoadPicture wanted = work.visitor.felt->order;
    wanted.page = place.page;
    wanted.view = place.view;
    wanted.zoom = {};
    if (item == VisitItem::next_view) wanted.view = place.view + 1;
    if (item == VisitItem::view_before) wanted.view = place.view - 1;
    if (item == VisitItem::next_page || item == VisitItem::page_before) {
        wanted.page = place.page + (item == VisitItem::next_page ? 1 : -1);
        wanted.view = 1;
    }
    open_again(work, wanted, LoadReason::other_view);
}

void find_thing_here(VisitWork& work) {
    LoadPicture wanted = work.visitor.felt->order;
    wanted.view = work.visitor.felt->facts.place.view;
    wanted.thing_at = in_whole_picture(work, work.visitor.handle.place_W);
    wanted.zoom = {};
    open_again(work, wanted, LoadReason::thing_here);
}

void other_shape(VisitWork& work) {
    const std::size_t shape = work.visitor.felt->order.index == 0 ? 1 : 0;
    open_picture(work, PictureSource::practice, shape, {});
}

void capture(VisitWork& work) {
    if (!work.site.has_camera) {
        return refuse(work, words(work, "The camera does not answer. Tell the staff."));
    }
    work.visitor.is_capturing = true;
    order(work, Capture{});
    enter(work, VisitScreen::opening);
}

void call_staff(VisitWork& work) {
    work.site.is_staff_called = !work.site.is_staff_called;
    order(work, CallStaff{work.site.is_staff_called});
    const std::string told = words(
        work, work.site.is_staff_called ? "The staff have been called. You can carry on meanwhile."
                                        : "The staff are no longer called.");
    const bool is_trouble = open_screen(work) == VisitScreen::trouble;
    is_trouble ? close_trouble(work, told) : say(work, told);
}

void toggle(VisitWork& work, bool& value) {
    value = !value;
    say_item(work);
}

/// Says first how speech comes back, for a visitor who hears nothing cannot ask.
void toggle_speech(VisitWork& work) {
    bool& is_on = work.visitor.sound.is_speech_on;
    is_on = !is_on;
    if (is_on) return say_item(work);
    say(work, language_of(work).text("speech", "Speech is off. Press Help to turn it on again."));
}

void confirm(VisitWork& work) {
    switch (static_cast<VisitItem>(work.visitor.path.back().about)) {
        case VisitItem::finish:
            return end_visit(work, VisitScreen::goodbye);
        case VisitItem::start_over:
            end_visit(work, VisitScreen::attract);
            return begin_visit(work);
        default:
            reset_settings(work);
            leave(work);
            return say_return(work,
                              words(work, "All settings are back as they were at the start."));
    }
}

void lead_to_part(VisitWork& work, std::size_t part) {
    const PartFacts& wanted = work.visitor.felt->facts.parts[part];
    lead(work, {GuideKind::to_place, wanted.place_W, -1},
         words(work, "The handle will guide you to this part: {0}.", {wanted.name}));
}

void take_row(VisitWork& work, std::size_t row, const std::string& name) {
    const Standing open = work.visitor.path.back();
    switch (open.screen) {
        case VisitScreen::language:
            work.visitor.sound.language = row;
            go_to(work, VisitScreen::choose);
            return say_screen(work);
        case VisitScreen::gallery:
            return open_picture(work, PictureSource::gallery, row, name);
        case VisitScreen::stick:
            return open_picture(work, PictureSource::stick, row, name);
        case VisitScreen::letters:
            return take_letter(work, row);
        case VisitScreen::parts:
            return lead_to_part(work, row);
        case VisitScreen::zoom:
            return zoom_in_on_part(work, row);
        case VisitScreen::values:
            return choose_value(work, static_cast<VisitItem>(open.about), row);
        default:
            return;
    }
}

void take_picture_item(VisitWork& work, VisitItem item) {
    const Position hand_W = work.visitor.handle.place_W;
    switch (item) {
        case VisitItem::lead_round:
            return lead(work, {GuideKind::outline, {}, work.visitor.felt->facts.outer_outline},
                        words(work, "The handle will guide you round the outline."));
        case VisitItem::bring_back:
            return lead(work, {GuideKind::bring_back, {}, -1},
                        words(work, "The handle will guide you back to a line."));
        case VisitItem::tell_again:
            return say(work, told_picture(work));
        case VisitItem::where_am_i:
            return say(work, told_place(work));
        case VisitItem::whole_picture:
            return zoom_around(work, {}, 1.0);
        case VisitItem::twice_here:
            return zoom_around(work, hand_W, 2.0);
        case VisitItem::four_times_here:
            return zoom_around(work, hand_W, 4.0);
        case VisitItem::thing_here:
            return find_thing_here(work);
        case VisitItem::next_view:
        case VisitItem::view_before:
        case VisitItem::next_page:
        case VisitItem::page_before:
            return step_view(work, item);
        case VisitItem::parts:
            return open(work, VisitScreen::parts);
        case VisitItem::explore:
            return open(work, VisitScreen::explore);
        case VisitItem::zoom:
            return open(work, VisitScreen::zoom);
        case VisitItem::turn_left:
        case VisitItem::turn_right:
        case VisitItem::turn_back:
            return turn_shape(work, item);
        case VisitItem::pages:
            return open(work, VisitScreen::pages);
        case VisitItem::other_shape:
            return other_shape(work);
        default:
            return;
    }
}

/// Opens the list that the picture came from.
void choose_another(VisitWork& work) {
    switch (work.visitor.felt->order.source) {
        case PictureSource::gallery:
            go_to(work, VisitScreen::gallery);
            break;
        case PictureSource::stick:
            go_to(work, VisitScreen::stick);
            return_to_file(work, work.visitor.felt->order.index);
            break;
        case PictureSource::camera:
            go_to(work, VisitScreen::camera);
            break;
        case PictureSource::practice:
            go_to(work, VisitScreen::choose);
            break;
    }
    say_screen(work);
}

void return_to_picture(VisitWork& work) {
    go_to(work, VisitScreen::picture);
    say_return(work);
}

void take(VisitWork& work, VisitItem item) {
    Visitor& visitor = work.visitor;
    switch (item) {
        case VisitItem::back:
        case VisitItem::no:
            return step_back(work);
        case VisitItem::cancel:
            return cancel_loading(work);
        case VisitItem::go_on:
            return close_trouble(work);
        case VisitItem::back_to_picture:
            return return_to_picture(work);
        case VisitItem::another_picture:
            return choose_another(work);
        case VisitItem::practise:
            return open_picture(work, PictureSource::practice, 0, {});
        case VisitItem::gallery:
            return open(work, VisitScreen::gallery);
        case VisitItem::stick:
            return open(work, VisitScreen::stick);
        case VisitItem::camera:
            return open(work, VisitScreen::camera);
        case VisitItem::settings:
            return open(work, VisitScreen::settings);
        case VisitItem::call_staff:
            return call_staff(work);
        case VisitItem::finish:
        case VisitItem::start_over:
        case VisitItem::reset:
            return open(work, VisitScreen::confirm, static_cast<int>(item));
        case VisitItem::yes:
            return confirm(work);
        case VisitItem::next_ten:
            return turn_page(work, +1);
        case VisitItem::ten_before:
            return turn_page(work, -1);
        case VisitItem::letters:
            return open_letters(work);
        case VisitItem::all_files:
            return show_all_files(work);
        case VisitItem::take_picture:
            return capture(work);
        case VisitItem::mono:
            return toggle(work, visitor.sound.is_mono);
        case VisitItem::speech:
            return toggle_speech(work);
        case VisitItem::screen:
            return toggle(work, visitor.look.is_off);
        case VisitItem::language:
        case VisitItem::volume:
        case VisitItem::rate:
        case VisitItem::sounds:
        case VisitItem::text_size:
        case VisitItem::palette:
        case VisitItem::detail:
        case VisitItem::mode:
        case VisitItem::stiffness:
        case VisitItem::held_shape:
            return open_values(work, item);
        default:
            return take_picture_item(work, item);
    }
}

}  // namespace

void select(VisitWork& work) {
    const SpokenScreen screen = screen_of(work);
    if (!screen.focus) {
        cue(work, ScreenEvent::key_refused);
        shake(work, HandlePattern::error);
        return say_screen(work);
    }
    const ScreenItem item = screen.items[*screen.focus];
    cue(work, ScreenEvent::key_taken);
    shake(work, HandlePattern::chosen);
    constexpr int first_row = static_cast<int>(VisitItem::entry);
    if (item.id >= first_row) {
        return take_row(work, static_cast<std::size_t>(item.id - first_row), item.name);
    }
    take(work, static_cast<VisitItem>(item.id));
}

}  // namespace touchline
