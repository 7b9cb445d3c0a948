// Everything that an operator set, in one file: settings, levels of sound, keys. No PIN, no
// counters.
// Threads: any, each call by itself; they wait for the disk.
#pragma once

#include "config/settings/keys.h"
#include "config/settings/settings.h"
#include "config/settings/sound.h"
#include "config/types/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace touchline {

struct Backup {
    Settings settings;  // those of the site's file
    SoundSettings sound;
    KeyTable keys;

    friend bool operator==(const Backup&, const Backup&) = default;
};

/// The file's name on a stick.
inline constexpr std::string_view backup_name = "touchline-backup.txt";

[[nodiscard]] std::string backup_text(const Backup& backup);

/// Reads the whole text, and judges every value as in its own file; or one line with file, line,
/// and what to do. Refuses another version of the format.
[[nodiscard]] Result<Backup> parse_backup(std::string_view text, std::string_view name);

/// Writes FOLDER/touchline-backup.txt, whole or not at all.
[[nodiscard]] Result<void> write_backup(const std::filesystem::path& folder, const Backup& backup);

/// Reads FOLDER/touchline-backup.txt, at most 4 MB.
[[nodiscard]] Result<Backup> read_backup(const std::filesystem::path& folder);

}  // namespace touchline
