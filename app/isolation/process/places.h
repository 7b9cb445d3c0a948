// The places of the program and its companions.
// Threads: any, as long as nothing in the program changes its environment.
#pragma once

#include <filesystem>
#include <string>

namespace touchline {

/// A variable of the environment; empty if it is not set.
[[nodiscard]] std::string environment(const char* name);

/// The folder of this program, with links followed; empty if the system does not tell.
[[nodiscard]] std::filesystem::path own_folder();

/// A file or folder that is installed with the program: `beside_program`, relative to own_folder(),
/// if that exists, else `source`, where it was built.
[[nodiscard]] std::filesystem::path installed_place(const std::string& beside_program,
                                                    const std::string& source);

/// XDG_CONFIG_HOME, else .config of the user's home, else /etc.
[[nodiscard]] std::filesystem::path user_settings_folder();

/// XDG_DATA_HOME, else .local/share of the user's home, else /var/lib.
[[nodiscard]] std::filesystem::path user_data_folder();

/// Another program of Touchline: in TOUCHLINE_PROGRAMS if it is set, else beside this one.
[[nodiscard]] std::string companion(const std::string& name);

}  // namespace touchline
