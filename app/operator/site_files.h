// The site's own key table and levels of sound, beside its settings.
// Threads: any, each call by itself; calls wait for the disk.
#pragma once

#include "config/settings/keys.h"
#include "config/settings/sound.h"
#include "config/types/result.h"

#include <filesystem>
#include <string>

namespace touchline {

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

}  // namespace touchline
