// touchline settings: whether a file of settings can be used, and what holds with it.
// Threads: one.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace touchline {

/// check: one line says that the file can be used, and how many settings it sets. print: all
/// settings as TOML.
enum class SettingsAction : std::uint8_t { check, print };

struct SettingsCommandOptions {
    SettingsAction action = SettingsAction::check;
    std::string file;  // empty: the site's, which need not be there
};

/// A line for every fault of the file (settings_text.h), among them a language that nobody has; a
/// file that cannot be read is one. Empty: done, and nothing else was written to `out` but that.
[[nodiscard]] std::vector<std::string> run_settings(const SettingsCommandOptions& options,
                                                    std::ostream& out);

}  // namespace touchline
