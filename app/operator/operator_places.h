// The tables of the operator's screens: the parent of each, its texts, and its items.
// Threads: constants.
#pragma once

#include "app/operator/operator.h"

#include <span>
#include <string_view>

namespace touchline {

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
    zero_counters,
    export_log,
    save_recording,
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
};

[[nodiscard]] std::span<const ActionRow> action_rows();

/// The text of a question.
[[nodiscard]] std::string_view words_of(Question question);

}  // namespace touchline
