// Profiles: files of settings for a kind of visitor. The program's own settings come first, then
// the site's, then those of the profile in use; the later ones hold. Threads: any; reading waits
// for the disk.
#pragma once

#include "config/settings/settings.h"
#include "config/types/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace touchline {

struct Profile {
    std::string name;               // the file's, without .toml
    std::string text;               // TOML
    std::vector<std::size_t> rows;  // the indices of setting_rows() that it sets
};

/// The folder of the installed profiles.
[[nodiscard]] std::filesystem::path profiles_folder();

/// The NAME.toml files of a folder, sorted by name; at most 32. Leaves out one that cannot be used,
/// and adds a line to `problems`.
[[nodiscard]] std::vector<Profile> read_profiles(const std::filesystem::path& folder,
                                                 std::vector<std::string>& problems);

/// The site's settings with those of the profile that they name. Refuses, in one sentence, a
/// profile that does not exist, or that would raise what the site bounds.
[[nodiscard]] Result<Settings> with_profile(const Settings& site,
                                            const std::vector<Profile>& profiles);

}  // namespace touchline
