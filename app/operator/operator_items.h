// What can be chosen on each of the operator's screens. Threads: values and pure functions.
#pragma once

#include "app/operator/operator.h"

#include <vector>

namespace touchline {

/// What an item stands for. ScreenItem::id holds it with its index.
enum class OperatorItem : std::uint8_t {
    place,          // index: an OperatorPlace
    setting,        // of setting_rows()
    hours_begin,    // of setting_rows()
    hours_end,      // of setting_rows()
    hours_are_set,  // of setting_rows(): quiet hours, or none
    action,         // an OperatorAction
    language,       // of OperatorWorld::languages: offered or not
    first_language,
    volume,    // headset, speaker
    loudness,  // of a full sine: headset, speaker
    profile,   // of OperatorWorld::profiles; behind them: none
    kind,      // of kind_rows()
    test,      // a TestStep
    fact,      // text only
    on_stick,  // of OperatorWorld::on_stick
    no,
    yes,
};

struct ItemMeaning {
    OperatorItem item = OperatorItem::fact;
    std::size_t index = 0;
};

[[nodiscard]] ItemMeaning meaning_of(const ScreenItem& item);

/// Of any screen but the wizard's and a test's step, which have their own.
[[nodiscard]] std::vector<ScreenItem> operator_items(const Operator& state,
                                                     const OperatorWorld& world);

/// The profile in use sets this row, of setting_rows().
[[nodiscard]] bool is_set_by_profile(std::size_t row, const Operator& state,
                                     const OperatorWorld& world);

}  // namespace touchline
