// The visitor's menu: rows of screens and items, and the engine that draws them, pages them, and
// does what is chosen. Only for visit_*.cpp and their tests.
// Threads: constant data, pure functions, and values of one step.
#pragma once

#include "app/visit/list_parts.h"
#include "app/visit/visit_work.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace touchline {

/// A screen while it is being written. The English texts belong to the context "visit".
struct VisitSheet {
    const Visit& visit;
    const VisitWorld& world;
    const Language& language;
    SpokenScreen screen;

    [[nodiscard]] const Visitor& visitor() const { return visit.visitor; }

    /// Only while a picture is felt.
    [[nodiscard]] const KnownPicture& felt() const { return *visit.visitor.felt; }

    [[nodiscard]] std::string words(const char* english) const;
    void title(const char* english);
    void sentence(const char* english);

    /// Adds text that is in the visitor's language already.
    void told(const SpokenText& text);

    /// `hint`: nothing is that of its kind. `place`: ScreenItem::place. A recording of the name is
    /// heard where it is short.
    void row(std::size_t number, const SpokenText& name, const std::string& value = {},
             const char* hint = nullptr, const std::optional<std::string>& place = {});
};

using VisitAct = void (*)(VisitWork&);

/// Where a setting is kept, as the index of its value.
struct KeptValue {
    std::size_t (*chosen)(const Visitor&);
    void (*choose)(VisitWork&, std::size_t value);
};

template <auto part, auto member>
[[nodiscard]] std::size_t kept_value(const Visitor& visitor) {
    return static_cast<std::size_t>(visitor.*part.*member);
}

template <auto part, auto member>
void keep_value(VisitWork& work, std::size_t value) {
    auto& kept = work.visitor.*part.*member;
    kept = static_cast<std::remove_reference_t<decltype(kept)>>(value);
}

/// A setting that is one member of the visitor's sound, look or feel.
template <auto part, auto member>
inline constexpr KeptValue kept_in{kept_value<part, member>, keep_value<part, member>};

/// Names in the catalogue, in the order of their enumeration or steps.
template <std::size_t count>
struct NamedValues {
    const char* context;
    std::array<const char*, count> names;
};

/// VisitSetting::names of such a table.
template <const auto& values>
[[nodiscard]] std::vector<std::string> named(const VisitWorld& /*world*/,
                                             const Language& language) {
    std::vector<std::string> names;
    for (const char* name : values.names) names.push_back(language.text(values.context, name));
    return names;
}

/// Opens the screen of its values.
struct VisitSetting {
    std::vector<std::string> (*names)(const VisitWorld&, const Language&);  // one for each value
    KeptValue value;
};

/// Turns to its other value at once.
struct VisitSwitch {
    KeptValue value;
    std::size_t on = 1;       // the value that is called on; 0 or 1
    VisitAct tell = nullptr;  // nothing: says the item
};

/// All rows of a list. `take`: one of them, by what it stands for and its name.
struct VisitList {
    void (*write)(VisitSheet&);
    void (*take)(VisitWork&, std::size_t number, const std::string& name);
};

/// What choosing an item does. A screen is opened; `confirm` then asks for the item.
using VisitChoice = std::variant<VisitScreen, VisitAct, VisitSetting, VisitSwitch, VisitList>;

/// A row of a screen; the rows of one screen are in its order.
struct VisitItemRow {
    VisitScreen screen;
    VisitItem item;    // of a list: entry
    const char* name;  // of a list: empty
    VisitChoice does;
    const char* hint = nullptr;                     // nothing: that of its kind
    bool (*is_shown)(const VisitSheet&) = nullptr;  // nothing: always
    std::string (*value)(const VisitSheet&) = nullptr;
    bool needs_force = false;  // while there is none, it says so
};

struct VisitScreenRow {
    VisitScreen screen;
    const char* title = nullptr;           // nothing: `write` writes it
    const char* text = nullptr;            // a sentence; nothing: none
    void (*write)(VisitSheet&) = nullptr;  // what of title and text depends on the visit
    const char* back_item = nullptr;       // the name of its last item, which goes back
    VisitAct back = step_back;             // what the key Back does
    VisitAct any_key = nullptr;            // what every key does here, and nothing else
    ScreenView view = ScreenView::none;
};

struct VisitMenu {
    std::span<const VisitScreenRow> screens;
    std::span<const VisitItemRow> items;
};

[[nodiscard]] VisitMenu main_menu();      // visit_screens.cpp
[[nodiscard]] VisitMenu picture_menu();   // visit_picture_screens.cpp
[[nodiscard]] VisitMenu drawing_menu();   // visit_drawing.cpp
[[nodiscard]] VisitMenu settings_menu();  // visit_settings.cpp
[[nodiscard]] VisitMenu list_menu();      // visit_lists.cpp

[[nodiscard]] const VisitScreenRow& row_of(VisitScreen screen);

/// The row of an item that is a setting.
[[nodiscard]] const VisitItemRow& setting_row(VisitItem setting);

/// Enters the screen and says it.
void show(VisitWork& work, VisitScreen screen, int about = 0, std::size_t focus = 0);

/// Writes each key and its use, to be read (visit_keys.cpp).
void write_keys(VisitSheet& sheet);

/// Opens another page, or another view of it, of the document that is felt.
void open_view(VisitWork& work, int page, int view);

/// The rows of an open list that it shows, each by itself or in parts.
[[nodiscard]] ListPart shown_part(const Standing& open, std::size_t rows);

/// Opens a part of the open list, without a word.
void enter_part(VisitWork& work, VisitScreen list, const ListPart& part);

[[nodiscard]] bool has_gallery(const VisitWorld& world);

/// The title of what is felt, or what stands for it.
[[nodiscard]] std::string picture_title(const VisitSheet& sheet);

}  // namespace touchline
