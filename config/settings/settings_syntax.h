// Private to config/settings. Reads a text of settings as TOML and goes on past what is not TOML,
// so that every fault of a file is reported at once.
// Threads: values and pure functions.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

namespace touchline {

struct SettingFault {
    std::size_t line = 0;  // in the text, from 1; 0: the text as a whole
    std::string words;     // one line

    friend auto operator<=>(const SettingFault&, const SettingFault&) = default;
};

struct SettingsTree {
    toml::table table;                 // from the sound lines
    std::vector<SettingFault> faults;  // in the other lines
};

/// Finds at most `most_faults` (>= 1) faults, and reads nothing after the last one. A table that is
/// begun twice is in the tree under two names; table_name() returns the one that was meant. O(text)
/// a fault.
[[nodiscard]] SettingsTree settings_tree(std::string_view text, std::size_t most_faults);

/// Returns the name of a table of the tree as it is in the text.
[[nodiscard]] std::string_view table_name(std::string_view key);

}  // namespace touchline
