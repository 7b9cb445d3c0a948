// What a visitor or an operator chooses one of. Threads: values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace touchline {

/// How much a visitor hears, chosen by one key: only alerts; the short sounds too; or also the
/// distance to the nearest line and, if chosen, the position tone.
enum class CueAmount : std::uint8_t { none, cues, full };

/// How few switches reach all roles: not at all; one moves and the other selects; the focus moves
/// by itself and one selects.
enum class SwitchUse : std::uint8_t { none, move_and_select, by_itself };

/// The first is the default (EN 301 549, 5.1.4).
enum class TextSize : std::uint8_t { normal, large, larger, largest };

/// The first is the default.
enum class PaletteName : std::uint8_t {
    white_on_black,
    black_on_white,
    yellow_on_black,
    low_glare_grey
};

/// How a braille line is written; off: no line is looked for.
enum class BrailleUse : std::uint8_t { off, uncontracted, contracted };

/// What the site's printer is given: swell paper of one of two sizes, or text for an embosser. The
/// first is the default.
enum class SheetKind : std::uint8_t { a4, letter, embosser };

inline constexpr int sheet_kind_count = 3;

/// Which make of device the site has (app/force/backends). The first is the default.
enum class DeviceMake : std::uint8_t { usb_board, moteus, odrive, inverse3 };

/// Their names in files and on the servo's command line, in the order of the enumeration.
inline constexpr std::array<std::string_view, 4> device_makes{"usb-board", "moteus", "odrive",
                                                              "inverse3"};

[[nodiscard]] constexpr std::string_view name_of(DeviceMake make) {
    return device_makes.at(static_cast<std::size_t>(make));
}

/// The language in which a text is wanted, tagged as BCP 47 and SVG's xml:lang do: "en", "de",
/// "pt-BR". Any text is a tag: a language without texts gets what exists. Empty means English. The
/// tag comes from the person who chose a language, never from the process's locale.
struct LanguageTag {
    std::string text = "en";

    friend bool operator==(const LanguageTag&, const LanguageTag&) = default;
};

}  // namespace touchline
