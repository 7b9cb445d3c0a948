// Reads and writes settings as TOML. Threads: pure functions, except for reading a file.
#pragma once

#include "config/settings/setting_rows.h"
#include "config/types/result.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// Returns "NAME:LINE: WORDS", as every fault of a settings file is told: one line, whatever the
/// words hold. Lines count from 1; 0 is the file as a whole.
[[nodiscard]] std::string line_in_file(std::string_view name, std::size_t line, std::string words);

/// The largest size of a settings file: 1 MB.
inline constexpr std::size_t largest_settings_bytes = std::size_t{1} << 20U;

/// Reads the whole file. A file that cannot be read, or is larger than that, gives a one-line
/// error. Reads no more.
[[nodiscard]] Result<std::string> read_settings_file(const std::filesystem::path& file);

/// Returns `base` changed by the text of a file; `name` is the file's, for the error. Malformed
/// text, an unknown table or key, a value that is not allowed, or one that this layer may not set
/// gives a one-line error with file, line, key and what is allowed; then nothing of the file is
/// used. At most 1 MB.
[[nodiscard]] Result<Settings> apply_settings(const Settings& base, std::string_view text,
                                              std::string_view name, SettingLayer layer);

/// Returns every fault of a file, in the order of its lines, each as one line with file and line
/// number; at most 100, then a line that says there are more. Empty if apply_settings() accepts the
/// file on top of the program's defaults. `languages` holds the codes of the existing languages, so
/// that any other one is a fault; if empty, languages are not checked. O(text) for each fault that
/// is not TOML.
[[nodiscard]] std::vector<std::string> settings_faults(std::string_view text, std::string_view name,
                                                       SettingLayer layer,
                                                       std::span<const std::string> languages);

/// Returns which rows of setting_rows() the text of a file sets, in their order; none if the text
/// is malformed.
[[nodiscard]] std::vector<std::size_t> rows_in(std::string_view text);

/// Returns the settings that differ from `base`, each with its help as a comment. apply_settings()
/// reads them back to the same bits.
[[nodiscard]] std::string settings_text(const Settings& settings, const Settings& base);

/// The same with all settings.
[[nodiscard]] std::string settings_text(const Settings& settings);

}  // namespace touchline
