// Private to config/settings: a text of settings as TOML, read on past what is no TOML, so that
// every fault of a file is told at once.
// Threads: values and pure functions.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

namespace touchline {

struct SettingFault {
    std::size_t line = 0;  // of the text, from 1; 0: of the text as a whole
    std::string words;     // one line

    friend auto operator<=>(const SettingFault&, const SettingFault&) = default;
};

struct SettingsTree {
    toml::table table;                 // of the lines that are sound
    std::vector<SettingFault> faults;  // of the others
};

/// There are `most_faults` (>= 1) at most; after the last nothing more is read. A table that is
/// begun twice is in the tree under two names: table_name() has the one that was meant. O(text) a
/// fault.
[[nodiscard]] SettingsTree settings_tree(std::string_view text, std::size_t most_faults);

/// The name of a table of the tree, as the text has it.
[[nodiscard]] std::string_view table_name(std::string_view key);

}  // namespace touchline
