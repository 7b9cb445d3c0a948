// The only table of settings. Validation, the operator's screens, the spoken texts and the
// reference page in config/README.md all come from it. A new setting is a member of Settings and a
// row (setting_table.cpp). Threads: constant data and pure functions.
#pragma once

#include "config/settings/settings.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace touchline {

/// Where a value comes from; a later layer overrides an earlier one.
enum class SettingLayer : std::uint8_t { defaults, site, profile, session };

/// The member of Settings that a row is about. An enumeration is one of the row's choices.
using SettingField =
    std::variant<bool Settings::*, int Settings::*, double Settings::*, std::string Settings::*,
                 Mode Settings::*, CueAmount Settings::*, SwitchUse Settings::*,
                 BrailleUse Settings::*, TextSize Settings::*, PaletteName Settings::*,
                 SheetKind Settings::*, DeviceMake Settings::*>;

/// Hard bounds: no file and no screen may exceed them. NaN is in no range.
struct SettingRange {
    double least = 0.0;
    double most = 0.0;
    double step = 1.0;  // per key press
};

/// What a text may hold; allowed_texts() says it in words. A path has at most 4000 bytes, a
/// name 40.
enum class TextKind : std::uint8_t {
    path,
    device,
    hours,
    quiet,
    languages,
    language,
    notice,
    name,
    queue,
    port
};

/// house: several kiosks of one house have it alike, and a bundle brings it (app/house). kiosk: it
/// belongs to one kiosk, its place or what is plugged in there.
enum class SettingOwner : std::uint8_t { house, kiosk };

struct SettingRow {
    std::string_view table;  // in TOML
    std::string_view key;
    SettingField field;
    SettingRange range;                               // of numbers
    std::span<const std::string_view> choices;        // of an enumeration, in its order; else empty
    std::string_view name;                            // said and shown
    std::string_view unit;                            // spoken after a number; may be empty
    std::string_view help;                            // one sentence
    SettingLayer last_layer = SettingLayer::session;  // last layer that may set it
    TextKind text = TextKind::path;                   // for a std::string
    SettingOwner owner = SettingOwner::house;
};

/// Returns the rows in the order of the file and of the screens; the rows of a table are
/// neighbours.
[[nodiscard]] std::span<const SettingRow> setting_rows();

/// Returns the row of TABLE.KEY.
[[nodiscard]] const SettingRow* find_setting(std::string_view table, std::string_view key);

/// Describes what may be written: "a number from 200 to 700", "\"wall\" or \"groove\"", "true or
/// false".
[[nodiscard]] std::string allowed_values(const SettingRow& row);

/// Any TOML value that a setting can have.
using SettingValue = std::variant<bool, double, std::string>;

/// Returns the settings with this one changed. Returns nothing if the value is of another kind, out
/// of range, not finite, not one of the choices, not a whole number although one is due, or a text
/// that is not allowed.
[[nodiscard]] std::optional<Settings> with_value(Settings settings, const SettingRow& row,
                                                 const SettingValue& value);

/// Returns `kiosk` with every row that belongs to the house as it is in `house`.
[[nodiscard]] Settings with_settings_of_house(Settings kiosk, const Settings& house);

/// Returns `latest` with every row in which `edited` differs from `base` as it is in `edited`: what
/// two people changed at once, each something else. Rows that contradict each other may meet.
[[nodiscard]] Settings with_changes(Settings latest, const Settings& base, const Settings& edited);

/// Describes in one sentence what a later layer changed without being allowed to; empty if nothing.
/// A profile or a visit may lower the ceiling of the force, never raise it.
[[nodiscard]] std::string trespass(const Settings& before, const Settings& after);

/// Two settings that contradict each other.
struct SettingConflict {
    std::string_view one;    // TABLE.KEY
    std::string_view other;  // likewise
    std::string sentence;
};

/// Returns an empty list if there are no conflicts.
[[nodiscard]] std::vector<SettingConflict> conflicts(const Settings& settings);

/// Returns the value as with_value() takes it: a choice by its name.
[[nodiscard]] SettingValue value_of(const Settings& settings, const SettingRow& row);

/// Returns the settings after one key press up or down: a step of the range, the next choice, or
/// the other of two. Stays at the ends of a range and of the choices. Texts do not change.
[[nodiscard]] Settings stepped(const Settings& settings, const SettingRow& row, bool is_up);

/// Returns "500 newtons per metre", "groove" or "on", for voice and screen.
[[nodiscard]] std::string value_in_words(const Settings& settings, const SettingRow& row);

inline constexpr int minutes_a_day = 24 * 60;

/// From one minute of the day to another; past midnight if the end is before the beginning.
struct HoursOfDay {
    int begin_min = 0;            // 0 ... 1439
    int end_min = minutes_a_day;  // 1 ... 1440, never equal to the beginning

    friend bool operator==(const HoursOfDay&, const HoursOfDay&) = default;
};

/// Parses "09:00-17:00"; returns nothing for anything else.
[[nodiscard]] std::optional<HoursOfDay> hours_in(std::string_view text);

[[nodiscard]] std::string hours_text(const HoursOfDay& hours);

/// Returns whether this minute of the day, 0 ... 1439, is among them. The end is not.
[[nodiscard]] bool is_within(const HoursOfDay& hours, int minute);

/// Parses "en de fr": at least one code, at most 16, each once; returns nothing for anything else.
[[nodiscard]] std::optional<std::vector<std::string>> languages_in_text(std::string_view text);

[[nodiscard]] bool is_allowed(TextKind kind, std::string_view text);

/// Describes what may be written, in English, for files and their errors.
[[nodiscard]] std::string_view allowed_texts(TextKind kind);

}  // namespace touchline
