// Settings in the spoken language, and how much of a set value can act where it is felt. The rows
// hold English; the catalogue's context is "setting".
// Threads: pure functions.
#pragma once

#include "audio-cues/words/language.h"
#include "config/settings/setting_rows.h"
#include "config/types/hand_state.h"
#include "config/types/level_terms.h"

#include <optional>
#include <string>

namespace touchline {

[[nodiscard]] std::string setting_name(const SettingRow& row, const Language& language);

[[nodiscard]] std::string setting_help(const SettingRow& row, const Language& language);

/// "500 newtons per metre", "groove", "on".
[[nodiscard]] std::string setting_value(const Settings& settings, const SettingRow& row,
                                        const Language& language);

/// Says the hours and minutes of the day as "9:30", never "half past nine".
[[nodiscard]] std::string time_in_words(int minute, const Language& language);

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
