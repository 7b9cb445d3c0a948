// The items of each operator's screen. Threads: values and pure functions.
#pragma once

#include "app/operator/operator.h"

#include <vector>

namespace touchline {

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
    volume,    // 0 headset, 1 speaker
    loudness,  // of a full sine: 0 headset, 1 speaker
    profile,   // index of OperatorWorld::profiles; after the last: none
    kind,      // index of kind_rows()
    test,      // a TestStep
    fact,      // text only
    on_stick,  // index of OperatorWorld::on_stick
    no,
    yes,
};

struct ItemMeaning {
    OperatorItem item = OperatorItem::fact;
    std::size_t index = 0;
};

[[nodiscard]] ItemMeaning meaning_of(const ScreenItem& item);

/// The items of any screen except the wizard's and a test's step, which make their own.
[[nodiscard]] std::vector<ScreenItem> operator_items(const Operator& state,
                                                     const OperatorWorld& world);

/// True if the profile in use sets this row of setting_rows().
[[nodiscard]] bool is_set_by_profile(std::size_t row, const Operator& state,
                                     const OperatorWorld& world);

}  // namespace touchline
