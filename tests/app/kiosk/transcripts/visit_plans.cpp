#include "tests/app/kiosk/transcripts/visit_plans.h"

#include "app/operator/operator_menu.h"

#include <array>
#include <initializer_list>
#include <stdexcept>

namespace touchline {
namespace {

constexpr int row(int number) {
    return static_cast<int>(VisitItem::entry) + number;
}

/// The first language is the visitor's.
void begin(StagedKiosk& kiosk) {
    for (int i = 0; i < 2; ++i) {
        kiosk.press(KeyRole::select);
        kiosk.listen();
    }
}

void finish(StagedKiosk& kiosk) {
    kiosk.choose(VisitItem::finish);
    kiosk.choose(VisitItem::yes);
    kiosk.do_nothing(12.0);
}

void go_back(StagedKiosk& kiosk, int screens = 1) {
    for (int i = 0; i < screens; ++i) {
        kiosk.press(KeyRole::back);
        kiosk.listen();
    }
}

/// One of the easiest, which are the first part of the gallery's list; the list is open.
void open_easy_picture(StagedKiosk& kiosk, std::size_t place) {
    kiosk.choose(row(0));
    kiosk.choose(kiosk.screen().items.at(place).id);
    kiosk.wait_for(VisitScreen::picture);
}

void open_picture_of_gallery(StagedKiosk& kiosk, std::size_t place) {
    kiosk.choose(VisitItem::gallery);
    open_easy_picture(kiosk, place);
}

void first_visit(StagedKiosk& kiosk) {
    kiosk.press(KeyRole::select);
    kiosk.listen();
    for (std::size_t i = 0; i < kiosk.screen().items.size(); ++i) {
        kiosk.press(KeyRole::down);
        kiosk.listen();
    }
    kiosk.press(KeyRole::select);
    kiosk.listen();
    for (const KeyRole role : {KeyRole::help, KeyRole::up, KeyRole::down, KeyRole::back,
                               KeyRole::repeat, KeyRole::select, KeyRole::back, KeyRole::back}) {
        kiosk.press(role);
        kiosk.listen();
    }
    kiosk.choose(VisitItem::practise);
    kiosk.wait_for(VisitScreen::practice);
    kiosk.follow_a_line(6.0);
    kiosk.listen();
    kiosk.choose(VisitItem::lead_round);
    kiosk.do_nothing(15.0);
    kiosk.choose(VisitItem::back);
    open_easy_picture(kiosk, 2);
    kiosk.follow_a_line(8.0);
    kiosk.listen();
    kiosk.choose(VisitItem::parts);
    kiosk.choose(row(0));
    kiosk.do_nothing(5.0);
    go_back(kiosk);
    kiosk.choose(VisitItem::explore);
    kiosk.follow_a_line(8.0);
    kiosk.choose(VisitItem::where_am_i);
    for (int i = 0; i < 2; ++i) {
        kiosk.press(KeyRole::repeat);
        kiosk.listen();
    }
    go_back(kiosk, 2);
    finish(kiosk);
}

/// Parts of parts, and from picture to picture.
void gallery(StagedKiosk& kiosk) {
    begin(kiosk);
    kiosk.choose(VisitItem::gallery);
    kiosk.choose(kiosk.screen().items.at(1).id);
    kiosk.choose(kiosk.screen().items.at(2).id);
    kiosk.choose(kiosk.screen().items.at(4).id);
    kiosk.wait_for(VisitScreen::picture);
    for (int i = 0; i < 2; ++i) {
        kiosk.choose(VisitItem::next_picture);
        kiosk.wait_for(VisitScreen::picture);
    }
    kiosk.choose(VisitItem::picture_before);
    kiosk.wait_for(VisitScreen::picture);
    kiosk.choose(VisitItem::another_picture);
    go_back(kiosk, 3);
    finish(kiosk);
}

void full_stick(StagedKiosk& kiosk) {
    begin(kiosk);
    kiosk.put_full_stick();
    kiosk.choose(VisitItem::stick);
    kiosk.press(KeyRole::down);
    kiosk.listen();
    for (const KeyRole role : {KeyRole::select, KeyRole::down, KeyRole::select, KeyRole::up,
                               KeyRole::up, KeyRole::select}) {
        kiosk.press(role);
        kiosk.listen();
    }
    kiosk.wait_for(VisitScreen::picture);
    kiosk.choose(VisitItem::next_picture);
    kiosk.wait_for(VisitScreen::picture);
    kiosk.choose(VisitItem::another_picture);
    kiosk.pull_stick();
    go_back(kiosk);
    finish(kiosk);
}

void photograph(StagedKiosk& kiosk) {
    begin(kiosk);
    kiosk.choose(VisitItem::camera);
    kiosk.choose(VisitItem::take_picture);
    kiosk.wait_for(VisitScreen::picture);
    kiosk.follow_a_line(5.0);
    kiosk.listen();
    kiosk.choose(VisitItem::pages);
    kiosk.choose(VisitItem::next_view);
    kiosk.wait_for(VisitScreen::pages);
    go_back(kiosk);
    kiosk.choose(VisitItem::thing_here);
    kiosk.wait_for(VisitScreen::picture);
    kiosk.choose(VisitItem::zoom);
    kiosk.choose(VisitItem::twice_here);
    kiosk.wait_for(VisitScreen::picture);
    kiosk.choose(VisitItem::another_picture);
    go_back(kiosk);
    finish(kiosk);
}

void document(StagedKiosk& kiosk) {
    begin(kiosk);
    kiosk.choose(VisitItem::stick);
    kiosk.put_stick();
    kiosk.choose(row(0));
    kiosk.wait_for(VisitScreen::picture);
    kiosk.choose(VisitItem::pages);
    for (int page = 2; page <= 12; ++page) {
        kiosk.choose(VisitItem::next_page);
        kiosk.wait_for(VisitScreen::pages);
    }
    kiosk.choose(VisitItem::page_before);
    kiosk.wait_for(VisitScreen::pages);
    go_back(kiosk);
    kiosk.choose(VisitItem::another_picture);
    kiosk.pull_stick();
    go_back(kiosk);
    finish(kiosk);
}

/// A house of three lines, one of which was drawn wrong.
void drawing(StagedKiosk& kiosk) {
    begin(kiosk);
    kiosk.choose(VisitItem::draw_for_me);
    kiosk.draw_line({-0.03, -0.02}, {0.03, -0.02});
    kiosk.follow_a_line(4.0);
    kiosk.listen();
    kiosk.draw_line({-0.03, 0.0}, {0.0, 0.03});
    kiosk.listen();
    kiosk.draw_line({0.0, 0.03}, {0.04, 0.03});
    kiosk.listen();
    kiosk.erase_at({0.02, 0.03});
    kiosk.do_nothing(10.0);
    kiosk.draw_line({0.0, 0.03}, {0.03, 0.0});
    kiosk.draw_line({0.01, 0.0}, {0.0105, 0.0});
    kiosk.listen();
    kiosk.choose(VisitItem::parts);
    kiosk.choose(row(1));
    kiosk.do_nothing(5.0);
    go_back(kiosk);
    kiosk.choose(VisitItem::undo_line);
    kiosk.choose(VisitItem::redo_line);
    go_back(kiosk);
    kiosk.choose(VisitItem::back_to_picture);
    go_back(kiosk);
    finish(kiosk);
}

void settings(StagedKiosk& kiosk) {
    begin(kiosk);
    for (const KeyRole role : {KeyRole::louder, KeyRole::softer}) {
        kiosk.press(role);
        kiosk.listen();
    }
    kiosk.choose(VisitItem::settings);
    for (const auto& [setting, value] : {std::pair{VisitItem::volume, 4},
                                         {VisitItem::rate, 5},
                                         {VisitItem::sounds, 2},
                                         {VisitItem::text_size, 2},
                                         {VisitItem::palette, 3}}) {
        kiosk.choose(setting);
        kiosk.choose(row(value));
    }
    kiosk.choose(VisitItem::mono);
    kiosk.choose(VisitItem::screen);
    kiosk.choose(VisitItem::speech);
    kiosk.press(KeyRole::help);
    kiosk.listen();
    kiosk.choose(VisitItem::reset);
    kiosk.choose(VisitItem::yes);
    go_back(kiosk);
    open_picture_of_gallery(kiosk, 0);
    for (const auto& [setting, value] :
         {std::pair{VisitItem::detail, 4}, {VisitItem::mode, 0}, {VisitItem::stiffness, 0}}) {
        kiosk.choose(setting);
        kiosk.choose(row(value));
        kiosk.wait_for(VisitScreen::picture);
    }
    go_back(kiosk);
    finish(kiosk);
}

void trouble(StagedKiosk& kiosk) {
    begin(kiosk);
    kiosk.choose(VisitItem::stick);
    kiosk.put_stick();
    kiosk.choose(row(1));
    kiosk.wait_for(VisitScreen::trouble);
    kiosk.press(KeyRole::select);
    kiosk.listen();
    go_back(kiosk);
    open_picture_of_gallery(kiosk, 1);
    kiosk.choose(VisitItem::lead_round);
    kiosk.break_device();
    kiosk.press(KeyRole::select);
    kiosk.listen();
    kiosk.choose(VisitItem::lead_round);
    go_back(kiosk);
    kiosk.choose(VisitItem::call_staff);
    kiosk.home_device();
    finish(kiosk);
}

void time_out(StagedKiosk& kiosk) {
    begin(kiosk);
    kiosk.choose(VisitItem::practise);
    kiosk.wait_for(VisitScreen::practice);
    kiosk.do_nothing(100.0);
    kiosk.press(KeyRole::select);
    kiosk.listen();
    kiosk.do_nothing(100.0);
    kiosk.do_nothing(40.0);
}

/// Enters the digits 1, 1, 1, 1.
void enter_pin(StagedKiosk& kiosk) {
    for (int i = 0; i < 4; ++i)
        for (const KeyRole role : {KeyRole::up, KeyRole::select}) kiosk.press_quickly(role);
    kiosk.press(KeyRole::select);
    kiosk.listen();
}

void choose(StagedKiosk& kiosk, OperatorPlace place) {
    kiosk.choose(OperatorItem::place, static_cast<std::size_t>(place));
}

void choose(StagedKiosk& kiosk, OperatorAction action) {
    kiosk.choose(OperatorItem::action, static_cast<std::size_t>(action));
}

void operators_visit(StagedKiosk& kiosk) {
    for (const KeyRole role :
         {KeyRole::help, KeyRole::up, KeyRole::up, KeyRole::down, KeyRole::down, KeyRole::select})
        kiosk.press_quickly(role);
    kiosk.listen();
    enter_pin(kiosk);
    enter_pin(kiosk);
    for (const KeyRole role : {KeyRole::down, KeyRole::down, KeyRole::back, KeyRole::help}) {
        kiosk.press(role);
        kiosk.listen();
    }
    choose(kiosk, OperatorPlace::touch);
    choose(kiosk, OperatorPlace::feel);
    for (const KeyRole role : {KeyRole::down, KeyRole::repeat, KeyRole::select, KeyRole::up,
                               KeyRole::down, KeyRole::select}) {
        kiosk.press(role);
        kiosk.listen();
    }
    go_back(kiosk, 2);
    choose(kiosk, OperatorPlace::device);
    choose(kiosk, OperatorPlace::self_test);
    kiosk.choose(OperatorItem::test, static_cast<std::size_t>(TestStep::sound_left));
    for (int i = 0; i < 2; ++i) {
        kiosk.press(KeyRole::select);
        kiosk.listen();
    }
    go_back(kiosk);
    choose(kiosk, OperatorAction::clear_fault);
    go_back(kiosk);
    choose(kiosk, OperatorPlace::upkeep);
    choose(kiosk, OperatorPlace::counters);
    go_back(kiosk, 2);
    choose(kiosk, OperatorAction::leave);
}

/// One sheet is printed while the visitor goes on; the next finds no paper.
void print(StagedKiosk& kiosk) {
    begin(kiosk);
    open_picture_of_gallery(kiosk, 0);
    kiosk.choose(VisitItem::print_sheet);
    kiosk.choose(VisitItem::tell_again);
    kiosk.do_nothing(15.0);
    kiosk.listen();
    kiosk.press(KeyRole::repeat);
    kiosk.listen();
    kiosk.empty_printer();
    kiosk.choose(VisitItem::print_sheet);
    kiosk.press(KeyRole::select);
    kiosk.listen();
    kiosk.wait_for(VisitScreen::trouble);
    kiosk.press(KeyRole::select);
    kiosk.listen();
    go_back(kiosk);
    finish(kiosk);
}

/// Every other key is an item.
void two_switches(StagedKiosk& kiosk) {
    begin(kiosk);
    open_picture_of_gallery(kiosk, 0);
    kiosk.choose(VisitItem::lead_round);
    kiosk.press(KeyRole::select);
    kiosk.listen();
    kiosk.choose_key(KeyRole::repeat);
    kiosk.choose(VisitItem::back);
    kiosk.choose_key(KeyRole::help);
    for (const KeyRole role :
         {KeyRole::down, KeyRole::down, KeyRole::select, KeyRole::select}) {  // Back, twice
        kiosk.press(role);
        kiosk.listen();
    }
    finish(kiosk);
}

/// The items come by themselves; the visitor only waits and presses.
void one_switch(StagedKiosk& kiosk) {
    const auto choose = [&kiosk](VisitItem item) {
        kiosk.choose_when_it_comes(static_cast<int>(item));
    };
    kiosk.press(KeyRole::select);
    const SpokenScreen languages = kiosk.screen();
    kiosk.do_nothing(24.0);  // hears how to find each language
    kiosk.choose_when_it_comes(languages.items.at(languages.focus.value()).id);
    choose(VisitItem::practise);
    choose(VisitItem::lead_round);
    kiosk.do_nothing(15.0);
    while (!place_of(kiosk.screen().items, static_cast<int>(VisitItem::finish)))
        choose(VisitItem::back);
    choose(VisitItem::finish);
    choose(VisitItem::yes);
    kiosk.do_nothing(12.0);
}

constexpr std::array plans{
    VisitPlan{"first-visit", first_visit},
    VisitPlan{"gallery", gallery},
    VisitPlan{"full-stick", full_stick},
    VisitPlan{"photograph", photograph},
    VisitPlan{"document", document},
    VisitPlan{"drawing", drawing, SwitchUse::none, true},
    VisitPlan{"print", print, SwitchUse::none, false, true},
    VisitPlan{"settings", settings},
    VisitPlan{"trouble", trouble},
    VisitPlan{"time-out", time_out},
    VisitPlan{"operator", operators_visit},
    VisitPlan{"two-switches", two_switches, SwitchUse::move_and_select},
    VisitPlan{"one-switch", one_switch, SwitchUse::by_itself},
};

}  // namespace

std::span<const VisitPlan> visit_plans() {
    return plans;
}

Transcript act_out(const VisitPlan& plan, const std::string& language) {
    StagedKiosk kiosk({language, plan.two_switches, plan.offers_drawing, plan.has_printer});
    try {
        plan.act(kiosk);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(language + ", " + std::string(plan.name) + ": " + error.what() +
                                 " after\n" + text_of(kiosk.transcript(), language));
    }
    return kiosk.transcript();
}

std::string heading_of(const VisitPlan& plan) {
    return "# " + std::string(plan.name) + "\n\n";
}

}  // namespace touchline
