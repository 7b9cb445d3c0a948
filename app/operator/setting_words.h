// Settings in the spoken language. The rows hold English; the catalogue's context is "setting".
// Threads: pure functions.
#pragma once

#include "audio-cues/words/language.h"
#include "config/settings/setting_rows.h"

#include <string>

namespace touchline {

[[nodiscard]] std::string setting_name(const SettingRow& row, const Language& language);

[[nodiscard]] std::string setting_help(const SettingRow& row, const Language& language);

/// "500 newtons per metre", "groove", "on".
[[nodiscard]] std::string setting_value(const Settings& settings, const SettingRow& row,
                                        const Language& language);

/// Says the hours and minutes of the day as "9:30", never "half past nine".
[[nodiscard]] std::string time_in_words(int minute, const Language& language);

}  // namespace touchline
