// The site's own table of keys and levels of sound, beside its settings.
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

/// A file that is not there, or cannot be used, leaves the program's own keys; the note says so.
[[nodiscard]] KeptKeys read_keys(const std::filesystem::path& file);

/// Whole or not at all. A table without one of the six roles is refused: nobody could mend it.
[[nodiscard]] Result<void> keep_keys(const std::filesystem::path& file, const KeyTable& keys);

/// Whole or not at all. Levels that break the rules of sound.h are refused.
[[nodiscard]] Result<void> keep_sound(const std::filesystem::path& file,
                                      const SoundSettings& sound);

}  // namespace touchline
