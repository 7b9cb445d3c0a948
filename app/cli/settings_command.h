// touchline settings: whether a file of settings can be used, and what holds with it.
// Threads: one.
#pragma once

#include "config/types/result.h"

#include <cstdint>
#include <iosfwd>
#include <string>

namespace touchline {

/// check: one line says whether the file can be used, and how many settings it sets. print: all
/// settings as TOML.
enum class SettingsAction : std::uint8_t { check, print };

struct SettingsCommandOptions {
    SettingsAction action = SettingsAction::check;
    std::string file;  // empty: the site's, which need not be there
};

/// Fails with the line that says what is wrong with the file.
[[nodiscard]] Result<void> run_settings(const SettingsCommandOptions& options, std::ostream& out);

}  // namespace touchline
