#include "app/operator/settings_files.h"

#include "app/documents/decode/files.h"
#include "app/isolation/process/places.h"
#include "config/settings/setting_rows.h"
#include "config/settings/settings_text.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include <sys/stat.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

// A power cut leaves an empty file of one that was being written in place.
constexpr const char* nothing_set = "# Nothing is set: the program's own settings hold.\n";

Result<Settings> settings_in(const std::string& text, const fs::path& file) {
    return apply_settings(Settings{}, text, file.string(), SettingLayer::site);
}

/// If the disk takes nothing, only the copy is lost, not the settings.
void remember(const SettingsFiles& files, const std::string& text) {
    const auto known = read_text(files.last_good);
    if (known && *known == text) return;
    (void)write_whole_file(files.last_good.string(), text);
}

KeptSettings fall_back(const SettingsFiles& files, const std::string& why) {
    if (is_there(files.last_good)) {
        const auto settings = read_text(files.last_good).and_then([&](const std::string& text) {
            return settings_in(text, files.last_good);
        });
        if (settings) return {*settings, why + "; the settings before hold"};
    }
    return {Settings{}, why + "; the program's own settings hold"};
}

constexpr std::size_t most_profiles = 32;

std::vector<fs::path> files_in(const fs::path& folder, std::vector<std::string>& problems) {
    std::vector<fs::path> files;
    std::error_code error;
    fs::directory_iterator entry(folder, error);
    while (!error && entry != fs::directory_iterator()) {
        // What a bundle keeps beside its place, and what an editor does, begins with a dot.
        const bool is_hidden = entry->path().filename().string().starts_with('.');
        if (!is_hidden && entry->path().extension() == ".toml") files.push_back(entry->path());
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

SettingsFiles settings_files() {
    const std::string chosen = environment("TOUCHLINE_SETTINGS");
    const fs::path site =
        chosen.empty() ? user_settings_folder() / "touchline" / "kiosk.toml" : fs::path(chosen);
    return {site, fs::path(site).concat(".good")};
}

KeptSettings read_settings(const SettingsFiles& files) {
    if (!is_there(files.site)) return {};
    const auto text = read_text(files.site);
    if (!text) return fall_back(files, text.error().line);
    if (text->empty()) return fall_back(files, files.site.string() + ": is empty, as if cut off");
    const auto settings = settings_in(*text, files.site);
    if (!settings) return fall_back(files, settings.error().line);
    remember(files, *text);
    return {*settings, ""};
}

std::string site_text(const Settings& settings) {
    const std::string text = settings_text(settings, Settings{});
    return text.empty() ? nothing_set : text;
}

Result<void> keep_settings(const SettingsFiles& files, const Settings& settings) {
    return keep_text(files.site, site_text(settings));
}

fs::path profiles_folder() {
    return installed_place(TOUCHLINE_PROFILES_BESIDE_PROGRAM, TOUCHLINE_PROFILES_SOURCE);
}

fs::path site_profiles_folder() {
    return settings_files().site.parent_path() / "profiles";
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

std::vector<Profile> read_profiles(const fs::path& installed, const fs::path& site,
                                   std::vector<std::string>& problems) {
    std::vector<Profile> profiles =
        is_there(site) ? read_profiles(site, problems) : std::vector<Profile>();
    for (Profile& profile : read_profiles(installed, problems))
        if (std::ranges::find(profiles, profile.name, &Profile::name) == profiles.end())
            profiles.push_back(std::move(profile));
    std::ranges::sort(profiles, {}, &Profile::name);
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

fs::path keys_file() {
    return settings_files().site.parent_path() / "keys.toml";
}

fs::path site_sound_file() {
    return user_settings_folder() / "touchline" / "sound.toml";
}

KeptKeys read_keys(const fs::path& file) {
    if (!is_there(file)) return {default_keys(), ""};
    const auto keys = read_text(file).and_then(
        [&file](const std::string& text) { return parse_keys(text, file.string()); });
    if (keys) return {*keys, ""};
    return {default_keys(), keys.error().line + "; the program's own keys hold"};
}

Result<void> keep_keys(const fs::path& file, const KeyTable& keys) {
    const std::string text = keys_text(keys);
    const auto read_back = parse_keys(text, file.string());
    if (!read_back) return tl::unexpected(read_back.error());
    return keep_text(file, text);
}

Result<void> keep_sound(const fs::path& file, const SoundSettings& sound) {
    const std::string text = sound_text(sound);
    const auto read_back = parse_sound(text, file.string());
    if (!read_back) return tl::unexpected(read_back.error());
    return keep_text(file, text);
}

Result<void> keep_text(const fs::path& file, const std::string& text) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error)
        return failure("the folder " + file.parent_path().string() +
                       " cannot be made: " + error.message());
    return write_whole_file(file.string(), text);
}

FileWatch::FileWatch(fs::path file) : file_(std::move(file)), seen_(look()) {}

bool FileWatch::has_changed() {
    const auto now = look();
    return std::exchange(seen_, now) != now;
}

std::optional<FileWatch::Look> FileWatch::look() const {
    struct stat state {};

    if (::stat(file_.c_str(), &state) != 0) return std::nullopt;
    constexpr std::int64_t ns_per_s = 1'000'000'000;
    return Look{static_cast<std::uintmax_t>(state.st_size),
                state.st_mtim.tv_sec * ns_per_s + state.st_mtim.tv_nsec, state.st_ino};
}

}  // namespace touchline
