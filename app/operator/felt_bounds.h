// How much of a set value can act where it is felt. Threads: values and pure functions.
#pragma once

#include "audio-cues/words/language.h"
#include "config/settings/setting_rows.h"
#include "config/types/level_terms.h"
#include "config/types/stiffness_bound.h"

#include <optional>
#include <string>

namespace touchline {

/// The bounds as the servo reports them.
struct FeltBounds {
    StiffnessBound stiffness;
    std::optional<LevelTerms> levels;  // of the picture that is felt; nothing: no picture
};

/// "500 newtons per metre"; "650 newtons per metre set, 510 possible on this loop" if rate and
/// delay allow no more; "0 set, 2 possible in this picture".
[[nodiscard]] std::string felt_value(const Settings& settings, const SettingRow& row,
                                     const FeltBounds& bounds, const Language& language);

}  // namespace touchline
