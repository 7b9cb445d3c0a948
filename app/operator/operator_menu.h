// The operator's menu: the tables of its screens, actions, questions and kinds of handle, and the
// items that a screen has. Threads: constants, values and pure functions.
#pragma once

#include "app/operator/operator.h"

#include <span>
#include <string_view>
#include <vector>

namespace touchline {

struct OperatorTurn;

using OperatorAct = void (*)(OperatorTurn&);

struct PlaceRow {
    OperatorPlace place;
    OperatorPlace parent;  // where Back leads
    std::string_view title;
    std::string_view text;   // sentences; may be empty
    std::string_view table;  // the table of setting_rows() that are its items; may be empty
    bool is_listed = true;   // listed among the items of its parent
};

/// Not for `closed`.
[[nodiscard]] const PlaceRow& row_of(OperatorPlace place);

[[nodiscard]] std::span<const PlaceRow> place_rows();

enum class OperatorAction : std::uint8_t {
    learn_keys,
    find_home,
    clear_fault,
    run_all_tests,
    begin_cleaning,
    make_bundle,
    show_house_key,
    find_way_back,
    apply_bundle,
    go_back,
    trust_key,
    export_counters,
    zero_counters,
    export_log,
    save_recording,
    keep_drawing,
    back_up,
    restore,
    first_settings,
    new_pin,
    close,
    leave,
};

struct ActionRow {
    OperatorPlace place;
    OperatorAction action;
    std::string_view name;
    std::string_view hint;
    OperatorAct act;
};

[[nodiscard]] std::span<const ActionRow> action_rows();

struct QuestionRow {
    Question question;
    OperatorPlace place;  // where it was asked
    std::string_view text;
    OperatorAct yes;
};

[[nodiscard]] const QuestionRow& row_of(Question question);

/// A kind of handle, by what a hand finds on it. Texts of the catalogue, context "kind".
struct KindRow {
    std::string_view profile;  // of haptics/pantograph/profile.h
    std::string_view name;
    std::string_view hint;  // how to tell it from the others
};

/// One row per profile, the likeliest first.
[[nodiscard]] std::span<const KindRow> kind_rows();

/// What an item stands for. ScreenItem::id holds this value and an index.
enum class OperatorItem : std::uint8_t {
    place,          // index: an OperatorPlace
    setting,        // index of setting_rows()
    hours_begin,    // index of setting_rows()
    hours_end,      // index of setting_rows()
    hours_are_set,  // index of setting_rows(): quiet hours, or none
    action,         // an OperatorAction
    language,       // index of OperatorWorld::languages: offered or not
    first_language,
    volume,      // 0 headset, 1 speaker
    loudness,    // of a full sine: 0 headset, 1 speaker
    profile,     // index of OperatorWorld::profiles; after the last: none
    kind,        // index of kind_rows()
    test,        // a TestStep
    fact,        // text only
    on_stick,    // index of OperatorWorld::on_stick
    house_file,  // index of OperatorWorld::house_files
    no,
    yes,
};

struct ItemMeaning {
    OperatorItem item = OperatorItem::fact;
    std::size_t index = 0;
};

[[nodiscard]] ItemMeaning meaning_of(const ScreenItem& item);

/// ScreenItem::id of an item that means this.
[[nodiscard]] int id_of(const ItemMeaning& meaning);

/// The items of any screen except the wizard's and a test's step, which make their own.
[[nodiscard]] std::vector<ScreenItem> operator_items(const Operator& state,
                                                     const OperatorWorld& world);

/// True if the profile in use sets this row of setting_rows().
[[nodiscard]] bool is_set_by_profile(std::size_t row, const Operator& state,
                                     const OperatorWorld& world);

}  // namespace touchline
