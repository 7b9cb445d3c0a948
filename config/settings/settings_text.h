// Settings as TOML, in and out. Threads: pure functions.
#pragma once

#include "config/settings/setting_rows.h"
#include "config/types/result.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// `base` with what the text of a file sets; `name` is that file's, for the error. Malformed, an
/// unknown table or key, a value that is not allowed, or one that this layer may not set: one line
/// with file, line, key and what is allowed, and nothing of the file holds. At most 1 MB.
[[nodiscard]] Result<Settings> apply_settings(const Settings& base, std::string_view text,
                                              std::string_view name, SettingLayer layer);

/// Every fault of a file, in the order of its lines, each as one line with file and line number; at
/// most 100 and a line that there are more. Empty where apply_settings() takes it, laid on the
/// program's own. `languages`: the codes of those that there are, so that one that nobody has is a
/// fault; empty: nobody asks. O(text) for each fault that is no TOML.
[[nodiscard]] std::vector<std::string> settings_faults(std::string_view text, std::string_view name,
                                                       SettingLayer layer,
                                                       std::span<const std::string> languages);

/// Which rows of setting_rows() the text of a file sets, in their order; none of one that is
/// malformed.
[[nodiscard]] std::vector<std::size_t> rows_in(std::string_view text);

/// Those that differ from `base`, as apply_settings() reads them back to the same bits; each with
/// its help as a comment.
[[nodiscard]] std::string settings_text(const Settings& settings, const Settings& base);

/// All of them.
[[nodiscard]] std::string settings_text(const Settings& settings);

}  // namespace touchline
