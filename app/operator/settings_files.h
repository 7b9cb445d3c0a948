// The site's file of settings, and the last one that was good.
// Threads: any, each call by itself; calls wait for the disk. Two that write at once leave one of
// the two files, whole.
#pragma once

#include "config/settings/settings.h"
#include "config/types/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace touchline {

struct SettingsFiles {
    std::filesystem::path site;       // need not be there
    std::filesystem::path last_good;  // a copy of the site's file as it last could be used
};

/// TOUCHLINE_SETTINGS or kiosk.toml in the user's folder of settings; the copy is beside it.
[[nodiscard]] SettingsFiles settings_files();

struct KeptSettings {
    Settings settings;
    std::string note;  // one line worth telling; may be empty
};

/// What holds at this site. A file that cannot be used, or has not a byte, as one that was cut off,
/// changes nothing: the last good one holds, without one the program's own, and the note says so. A
/// good one becomes the last good.
[[nodiscard]] KeptSettings read_settings(const SettingsFiles& files);

/// Writes what differs from the program's own as the site's file.
[[nodiscard]] Result<void> keep_settings(const SettingsFiles& files, const Settings& settings);

/// Tells when a file has become another, by its size, its time and what it is on the disk.
class FileWatch {
  public:
    explicit FileWatch(std::filesystem::path file);

    /// Since the last call, or since the beginning.
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
