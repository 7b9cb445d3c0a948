#include "app/operator/profiles.h"

#include "app/documents/decode/files.h"
#include "app/isolation/process/places.h"
#include "app/operator/settings_files.h"
#include "config/settings/setting_rows.h"
#include "config/settings/settings_text.h"

#include <algorithm>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_profiles = 32;

std::vector<fs::path> files_in(const fs::path& folder, std::vector<std::string>& problems) {
    std::vector<fs::path> files;
    std::error_code error;
    fs::directory_iterator entry(folder, error);
    while (!error && entry != fs::directory_iterator()) {
        if (entry->path().extension() == ".toml") files.push_back(entry->path());
        entry.increment(error);
    }
    if (error) problems.push_back(folder.string() + ": the profiles cannot be read");
    std::sort(files.begin(), files.end());
    if (files.size() > most_profiles) files.resize(most_profiles);
    return files;
}

/// Checks only ranges; the site's bounds are checked when the profile is used.
Result<Profile> read_profile(const fs::path& file) {
    const auto text = read_text(file);
    if (!text) return tl::unexpected(text.error());
    Profile profile{file.stem().string(), *text, {}};
    if (profile.name.empty() || !is_allowed(TextKind::name, profile.name))
        return failure(file.string() + ": a profile is named by " +
                       std::string(allowed_texts(TextKind::name)));
    const auto settings =
        apply_settings(Settings{}, profile.text, file.string(), SettingLayer::profile);
    if (!settings) return tl::unexpected(settings.error());
    profile.rows = rows_in(profile.text);
    return profile;
}

}  // namespace

fs::path profiles_folder() {
    return installed_place(TOUCHLINE_PROFILES_BESIDE_PROGRAM, TOUCHLINE_PROFILES_SOURCE);
}

std::vector<Profile> read_profiles(const fs::path& folder, std::vector<std::string>& problems) {
    std::vector<Profile> profiles;
    for (const fs::path& file : files_in(folder, problems)) {
        auto profile = read_profile(file);
        if (profile)
            profiles.push_back(std::move(*profile));
        else
            problems.push_back(profile.error().line);
    }
    return profiles;
}

Result<Settings> with_profile(const Settings& site, const std::vector<Profile>& profiles) {
    if (site.profile.empty()) return site;
    const auto found = std::find_if(profiles.begin(), profiles.end(), [&](const Profile& profile) {
        return profile.name == site.profile;
    });
    if (found == profiles.end())
        return failure("the profile '" + site.profile +
                       "' is not there; choose another one, or none");
    return apply_settings(site, found->text, found->name + ".toml", SettingLayer::profile);
}

}  // namespace touchline
