// touchline settings: checks a settings file, and prints the resulting settings.
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
    std::string file;  // empty: the site's, which may be missing
};

/// Returns a line for every fault of the file (settings_text.h), including an unknown language and
/// an unreadable file. Empty: done. Writes nothing else to `out`.
[[nodiscard]] std::vector<std::string> run_settings(const SettingsCommandOptions& options,
                                                    std::ostream& out);

}  // namespace touchline
