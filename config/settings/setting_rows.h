// The one table of what can be set: from it come validation, the operator's screens, what is said
// of a setting, and the reference page in config/README.md. A new setting is a member of Settings
// and a row. Threads: constant data and pure functions.
#pragma once

#include "config/settings/settings.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace touchline {

/// Where a value comes from; a later one goes before an earlier one.
enum class SettingLayer : std::uint8_t { defaults, site, profile, session };

/// The member of Settings that a row is about. An int is one of the row's choices if it has any.
using SettingField =
    std::variant<bool Settings::*, int Settings::*, double Settings::*, std::string Settings::*>;

/// Hard bounds: no file and no screen passes them. NaN is in none.
struct SettingRange {
    double least = 0.0;
    double most = 0.0;
    double step = 1.0;  // of one key press
};

/// What a text is. path: from the root, or none. device: a path below /dev/input, or none. hours:
/// "09:00-17:00"; quiet: the same, or none. languages: codes with blanks between; language: one
/// code. notice: a line of at most 200 bytes, or none. name: of small
/// letters, digits and "-", or none.
enum class TextKind : std::uint8_t {
    path,
    device,
    hours,
    quiet,
    languages,
    language,
    notice,
    name
};

struct SettingRow {
    std::string_view table;  // in TOML
    std::string_view key;
    SettingField field;
    SettingRange range;                               // of numbers
    std::span<const std::string_view> choices;        // of an int that is one of these; else empty
    std::string_view name;                            // said and shown
    std::string_view unit;                            // said after a number; may be empty
    std::string_view help;                            // one sentence
    SettingLayer last_layer = SettingLayer::session;  // that may set it
    TextKind text = TextKind::path;                   // of a std::string
};

/// In the order of the file and of the screens; the rows of a table are neighbours.
[[nodiscard]] std::span<const SettingRow> setting_rows();

/// The row of TABLE.KEY.
[[nodiscard]] const SettingRow* find_setting(std::string_view table, std::string_view key);

/// What may be written: "a number from 200 to 700", "\"wall\" or \"groove\"", "true or false".
[[nodiscard]] std::string allowed_values(const SettingRow& row);

/// Any value that TOML has, as far as settings have it.
using SettingValue = std::variant<bool, double, std::string>;

/// The settings with this one changed; nothing if the value is of another kind, out of range, not
/// finite, none of the choices, no whole number where one is due, or a text that cannot be.
[[nodiscard]] std::optional<Settings> with_value(Settings settings, const SettingRow& row,
                                                 const SettingValue& value);

/// What a later layer may not do to an earlier one, as one sentence; empty if it did not: a profile
/// or a visit may lower the ceiling of the force, never raise it.
[[nodiscard]] std::string trespass(const Settings& before, const Settings& after);

/// What two settings say against each other.
struct SettingConflict {
    std::string_view one;    // TABLE.KEY
    std::string_view other;  // likewise
    std::string sentence;
};

/// Empty where none do.
[[nodiscard]] std::vector<SettingConflict> conflicts(const Settings& settings);

/// As with_value() takes it: a choice is its name.
[[nodiscard]] SettingValue value_of(const Settings& settings, const SettingRow& row);

/// One key press up or down: a step of the range, the next choice, the other of two. Stays at the
/// ends of a range and of the choices. Texts have no next.
[[nodiscard]] Settings stepped(const Settings& settings, const SettingRow& row, bool is_up);

/// "500 newtons per metre", "groove", "on", for voice and screen.
[[nodiscard]] std::string value_in_words(const Settings& settings, const SettingRow& row);

/// The table as Markdown, for config/README.md; ends with a newline.
[[nodiscard]] std::string settings_as_markdown();

}  // namespace touchline
