// The site's settings file and its last good copy, the profiles that go over it, its key table, and
// its levels of sound.
// Threads: any, each call by itself; calls wait for the disk. Two that write at once leave one of
// the two files, whole.
#pragma once

#include "config/settings/keys.h"
#include "config/settings/settings.h"
#include "config/settings/sound.h"
#include "config/types/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

struct SettingsFiles {
    std::filesystem::path site;       // may be missing
    std::filesystem::path last_good;  // a copy of the site's file when it was last usable
};

/// TOUCHLINE_SETTINGS or kiosk.toml in the user's folder of settings; the copy is beside it.
[[nodiscard]] SettingsFiles settings_files();

struct KeptSettings {
    Settings settings;
    std::string note;  // one line worth telling; may be empty
};

/// The settings of this site. A file that cannot be used changes nothing, nor does an empty one, as
/// after a power cut: the last good copy applies, or the program's own settings without one, and
/// the note says so. A good file becomes the last good copy.
[[nodiscard]] KeptSettings read_settings(const SettingsFiles& files);

/// The text of the site's file with these settings: those that differ from the program's own.
[[nodiscard]] std::string site_text(const Settings& settings);

/// Writes it.
[[nodiscard]] Result<void> keep_settings(const SettingsFiles& files, const Settings& settings);

/// Settings for a kind of visitor. The program's own settings come first, then the site's, then
/// those of the profile in use; the later ones hold.
struct Profile {
    std::string name;               // the file's, without .toml
    std::string text;               // TOML
    std::vector<std::size_t> rows;  // the indices of setting_rows() that it sets
};

/// The folder of the installed profiles.
[[nodiscard]] std::filesystem::path profiles_folder();

/// The folder of the site's own profiles, beside its settings; it may be missing.
[[nodiscard]] std::filesystem::path site_profiles_folder();

/// The NAME.toml files of a folder, sorted by name; at most 32. Leaves out one that cannot be used,
/// and adds a line to `problems`.
[[nodiscard]] std::vector<Profile> read_profiles(const std::filesystem::path& folder,
                                                 std::vector<std::string>& problems);

/// The installed profiles and the site's own, sorted by name; of two of one name the site's. A
/// folder of the site that is missing holds none.
[[nodiscard]] std::vector<Profile> read_profiles(const std::filesystem::path& installed,
                                                 const std::filesystem::path& site,
                                                 std::vector<std::string>& problems);

/// The site's settings with those of the profile that they name. Refuses, in one sentence, a
/// profile that does not exist, or that would raise what the site bounds.
[[nodiscard]] Result<Settings> with_profile(const Settings& site,
                                            const std::vector<Profile>& profiles);

/// keys.toml beside the site's settings.
[[nodiscard]] std::filesystem::path keys_file();

/// sound.toml in the user's folder of settings.
[[nodiscard]] std::filesystem::path site_sound_file();

struct KeptKeys {
    KeyTable keys;
    std::string note;  // one line worth telling; may be empty
};

/// Gives the program's own keys if the file does not exist or cannot be used; the note says so.
[[nodiscard]] KeptKeys read_keys(const std::filesystem::path& file);

/// Writes whole or not at all. Refuses a table without one of the six roles, for nobody could mend
/// it.
[[nodiscard]] Result<void> keep_keys(const std::filesystem::path& file, const KeyTable& keys);

/// Writes whole or not at all. Refuses levels that break the rules of sound.h.
[[nodiscard]] Result<void> keep_sound(const std::filesystem::path& file,
                                      const SoundSettings& sound);

/// Writes the file whole or not at all, and makes its folder.
[[nodiscard]] Result<void> keep_text(const std::filesystem::path& file, const std::string& text);

/// Notices that a file has changed, by its size, its time and its place on the disk.
class FileWatch {
  public:
    explicit FileWatch(std::filesystem::path file);

    /// Since the last call, or since construction.
    [[nodiscard]] bool has_changed();

  private:
    struct Look {
        std::uintmax_t bytes = 0;
        std::int64_t time_ns = 0;
        std::uintmax_t id = 0;

        friend bool operator==(const Look&, const Look&) = default;
    };

    [[nodiscard]] std::optional<Look> look() const;

    std::filesystem::path file_;
    std::optional<Look> seen_;
};

}  // namespace touchline
