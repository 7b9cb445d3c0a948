#include "app/visit/visit_menu.h"

#include <algorithm>
#include <array>
#include <utility>

namespace touchline {
namespace {

constexpr const char* choice_hint = "Press Select to choose this, Up or Down to move.";
constexpr const char* only_hint = "Press Select to choose this.";
constexpr const char* change_hint = "Press Select to change it.";
constexpr const char* switch_hint = "Press Select to choose this, or move on.";

/// Switches have no Up and Down, and a single one cannot move on.
const char* hint_of_choice(const VisitWorld& world) {
    if (has_keys(world)) return choice_hint;
    return moves_by_itself(world) ? only_hint : switch_hint;
}

std::array<VisitMenu, 5> menus() {
    return {main_menu(), picture_menu(), drawing_menu(), settings_menu(), list_menu()};
}

std::string told_value(const VisitSheet& sheet, const VisitSetting& setting) {
    const std::vector<std::string> names = setting.names(sheet.world, sheet.language);
    const std::size_t chosen = setting.value.chosen(sheet.visitor());
    return names[std::min(chosen, names.size() - 1)];
}

void add_item(VisitSheet& sheet, VisitItem item, const char* name) {
    sheet.screen.items.push_back({static_cast<int>(item),
                                  ItemRole::choice,
                                  sheet.words(name),
                                  {},
                                  sheet.words(hint_of_choice(sheet.world))});
}

void add_item(VisitSheet& sheet, const VisitItemRow& row) {
    if (const auto* const list = std::get_if<VisitList>(&row.does)) return list->write(sheet);
    add_item(sheet, row.item, row.name);
    ScreenItem& shown = sheet.screen.items.back();
    if (row.value != nullptr) shown.value = row.value(sheet);
    if (const auto* const setting = std::get_if<VisitSetting>(&row.does)) {
        shown.role = ItemRole::setting;
        shown.value = told_value(sheet, *setting);
        shown.hint = sheet.words(change_hint);
    }
    if (const auto* const toggle = std::get_if<VisitSwitch>(&row.does)) {
        shown.role = ItemRole::toggle;
        const bool is_on = toggle->value.chosen(sheet.visitor()) == toggle->on;
        shown.value = sheet.words(is_on ? "on" : "off");
        shown.hint = sheet.words(change_hint);
    }
    if (row.hint != nullptr) shown.hint = sheet.words(row.hint);
    if (row.needs_force && !has_force(sheet.visit.site)) {
        if (shown.value.empty()) shown.value = sheet.words("no force now");
        shown.hint = sheet.words(no_force_words);
    }
}

/// A part of a list has the list's rows alone.
bool is_shown(const VisitSheet& sheet, const VisitItemRow& row) {
    const bool is_part = open_standing(sheet.visitor()).end > 0;
    if (is_part && !std::holds_alternative<VisitList>(row.does)) return false;
    return row.is_shown == nullptr || row.is_shown(sheet);
}

void add_items(VisitSheet& sheet, VisitScreen screen) {
    for (const VisitMenu& menu : menus())
        for (const VisitItemRow& row : menu.items)
            if (row.screen == screen && is_shown(sheet, row)) add_item(sheet, row);
}

/// Rewords the hint of a single item, because it must not send anybody to another item.
void mind_the_only_item(VisitSheet& sheet) {
    if (sheet.screen.items.size() != 1) return;
    std::string& hint = sheet.screen.items.front().hint;
    if (hint != sheet.words(hint_of_choice(sheet.world))) return;
    const bool is_back = sheet.screen.items.front().id == static_cast<int>(VisitItem::back);
    hint = sheet.words(is_back ? "Press Select to go back." : only_hint);
}

/// The titles of the screens that Back leads to, the first one first.
std::vector<std::string> way_to(const VisitSheet& sheet) {
    const Visitor& visitor = sheet.visitor();
    std::vector<std::string> way;
    for (const Standing& below : visitor.path) {
        if (&below == &open_standing(visitor)) break;
        if (const char* const title = row_of(below.screen).title) way.push_back(sheet.words(title));
    }
    return way;
}

/// The row of an item that is shown now. Two rows of one item do the same.
const VisitItemRow* shown_row(VisitScreen screen, VisitItem item) {
    for (const VisitMenu& menu : menus())
        for (const VisitItemRow& row : menu.items)
            if (row.screen == screen && row.item == item) return &row;
    return nullptr;
}

/// Does what a chosen row says, one overload per kind.
struct Choose {
    VisitWork& work;
    VisitItem item;
    const ScreenItem& shown;

    void operator()(VisitScreen screen) const {
        show(work, screen, screen == VisitScreen::confirm ? shown.id : 0);
    }

    void operator()(VisitAct act) const { act(work); }

    void operator()(const VisitSetting& setting) const {
        show(work, VisitScreen::values, shown.id, setting.value.chosen(work.visitor));
    }

    void operator()(const VisitSwitch& toggle) const {
        toggle.value.choose(work, 1 - toggle.value.chosen(work.visitor));
        toggle.tell == nullptr ? say_item(work) : toggle.tell(work);
    }

    void operator()(const VisitList& list) const {
        list.take(work, static_cast<std::size_t>(shown.id - static_cast<int>(item)), shown.name);
    }
};

}  // namespace

std::string VisitSheet::words(const char* english) const {
    return language.text("visit", english);
}

void VisitSheet::title(const char* english) {
    screen.title = words(english);
}

void VisitSheet::sentence(const char* english) {
    told(words(english));
}

void VisitSheet::told(const SpokenText& text) {
    SpokenText all = told_text(screen);
    add_sentence(all, text);
    screen.text = std::move(all.words);
    screen.text_recorded = std::move(all.recorded);
}

void VisitSheet::row(std::size_t number, const SpokenText& name, const std::string& value,
                     const char* hint, const std::optional<std::string>& place) {
    screen.items.push_back({static_cast<int>(VisitItem::entry) + static_cast<int>(number),
                            ItemRole::choice, name.words, value,
                            words(hint == nullptr ? hint_of_choice(world) : hint), place});
    if (!name.recorded.empty())
        screen.items.back().recording = if_short(name.recorded.front().recording);
}

const VisitScreenRow& row_of(VisitScreen screen) {
    for (const VisitMenu& menu : menus()) {
        const auto found = std::ranges::find(menu.screens, screen, &VisitScreenRow::screen);
        if (found != menu.screens.end()) return *found;
    }
    return main_menu().screens.front();  // never: each screen has its row
}

const VisitItemRow& setting_row(VisitItem setting) {
    const auto is_it = [setting](const VisitItemRow& row) {
        return row.item == setting && std::holds_alternative<VisitSetting>(row.does);
    };
    for (const VisitMenu& menu : menus()) {
        const auto found = std::ranges::find_if(menu.items, is_it);
        if (found != menu.items.end()) return *found;
    }
    return settings_menu().items.front();  // not for an item that is no setting
}

SpokenScreen screen_of(const Visit& visit, const VisitWorld& world) {
    const Visitor& visitor = visit.visitor;
    const Standing& open = open_standing(visitor);
    const VisitScreenRow& row = row_of(open.screen);
    VisitSheet sheet{visit, world, language_of(visit, world), {}};
    if (row.title != nullptr) sheet.title(row.title);
    if (row.text != nullptr) sheet.sentence(row.text);
    if (row.write != nullptr) row.write(sheet);
    add_items(sheet, open.screen);
    if (row.back_item != nullptr) add_item(sheet, VisitItem::back, row.back_item);
    if (open.screen != VisitScreen::help) set_focus(sheet.screen, open.focus);
    mind_the_only_item(sheet);
    // A picture stays in view beneath what lies over it, and while somebody may draw in it.
    const ScreenView beneath = row_of(visitor.path.back().screen).view;
    const bool is_beneath = beneath == ScreenView::picture || takes_pen(visit);
    sheet.screen.view = is_beneath ? ScreenView::picture : row.view;
    sheet.screen.way = way_to(sheet);
    sheet.screen.takes_any_key = row.any_key != nullptr || visitor.leading.has_value();
    return sheet.screen;
}

void show(VisitWork& work, VisitScreen screen, int about, std::size_t focus) {
    enter(work, screen, about, focus);
    say_screen(work);
}

void select(VisitWork& work) {
    const SpokenScreen screen = screen_of(work);
    if (!screen.focus) {
        refuse(work);
        return say_screen(work);
    }
    const ScreenItem shown = screen.items[*screen.focus];
    const auto item =
        static_cast<VisitItem>(std::min(shown.id, static_cast<int>(VisitItem::entry)));
    cue(work, ScreenEvent::key_taken);
    shake(work, HandlePattern::chosen);
    // The language screen says another hint than that of its items.
    if (open_screen(work) != VisitScreen::language) hint_of(work.visitor, shown.hint).learn();
    if (item == VisitItem::back) return row_of(open_screen(work)).back(work);
    if (const auto* const row = shown_row(open_screen(work), item))
        std::visit(Choose{work, item, shown}, row->does);
}

}  // namespace touchline
