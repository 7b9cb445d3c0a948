// Where the program and its companions lie.
// Threads: any, as long as nothing in the program changes its environment.
#pragma once

#include <filesystem>
#include <string>

namespace touchline {

/// Of the environment; empty where there is none.
[[nodiscard]] std::string environment(const char* name);

/// The folder that this program was started from, links followed; empty where the system does not
/// tell.
[[nodiscard]] std::filesystem::path own_folder();

/// The file or folder at `beside_programs` from where this program lies, if there is one; else the
/// one in the sources that it was built from.
[[nodiscard]] std::filesystem::path installed_or(const std::filesystem::path& beside_programs,
                                                 const std::filesystem::path& in_sources);

/// Where what somebody set is kept: touchline in the user's folder of settings (XDG_CONFIG_HOME,
/// ~/.config), or in /etc for a user without a home.
[[nodiscard]] std::filesystem::path settings_folder();

/// Another program of Touchline: in TOUCHLINE_PROGRAMS where that is set, else beside this one.
[[nodiscard]] std::string companion(const std::string& name);

}  // namespace touchline
