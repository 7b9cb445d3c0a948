// Profiles: files of settings for a kind of visitor. What holds is the program's own settings, then
// the site's, then those of the profile in use. Threads: any; reading waits for the disk.
#pragma once

#include "config/settings/settings.h"
#include "config/types/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace touchline {

struct Profile {
    std::string name;               // of its file, without .toml
    std::string text;               // TOML
    std::vector<std::size_t> rows;  // of setting_rows() that it sets
};

/// Where those that are installed lie.
[[nodiscard]] std::filesystem::path profiles_folder();

/// NAME.toml of a folder, by name; at most 32. One that cannot be used is left out, and `problems`
/// has one line for it.
[[nodiscard]] std::vector<Profile> read_profiles(const std::filesystem::path& folder,
                                                 std::vector<std::string>& problems);

/// The site's settings with those of the profile that they name. A profile that is not there, or
/// that would raise what the site bounds, is refused: one sentence.
[[nodiscard]] Result<Settings> with_profile(const Settings& site,
                                            const std::vector<Profile>& profiles);

}  // namespace touchline
