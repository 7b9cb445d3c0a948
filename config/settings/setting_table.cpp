// The rows themselves, in the order of the file and of the screens.
#include "config/settings/setting_rows.h"

#include <array>

namespace touchline {
namespace {

using Names = std::array<std::string_view, 4>;

constexpr Names modes{"wall", "groove", "ridge", "stay"};
constexpr std::array<std::string_view, 3> amounts{"none", "short", "all"};
constexpr std::array<std::string_view, 3> switches{"off", "move and select", "by itself"};
constexpr std::array<std::string_view, 3> braille_uses{"off", "uncontracted", "contracted"};
constexpr Names text_sizes{"standard", "large", "larger", "largest"};
constexpr std::array<std::string_view, 3> sheets{"A4", "letter", "braille"};
constexpr Names palettes{"light on dark", "dark on light", "warm on dark", "low glare"};

// The names are in the order of the enumeration.
static_assert(static_cast<int>(Mode::wall) == 0 && static_cast<int>(Mode::stay) == 3);

constexpr SettingRow flag_row(std::string_view table, std::string_view key, bool Settings::*field,
                              std::string_view name, std::string_view help,
                              SettingLayer last_layer = SettingLayer::session) {
    return {table, key, field, {}, {}, name, "", help, last_layer};
}

constexpr SettingRow number_row(std::string_view table, std::string_view key, SettingField field,
                                SettingRange range, std::string_view name, std::string_view unit,
                                std::string_view help,
                                SettingLayer last_layer = SettingLayer::session) {
    return {table, key, field, range, {}, name, unit, help, last_layer};
}

constexpr SettingRow choice_row(std::string_view table, std::string_view key, SettingField field,
                                std::span<const std::string_view> choices, std::string_view name,
                                std::string_view help,
                                SettingLayer last_layer = SettingLayer::session) {
    return {table, key, field, {}, choices, name, "", help, last_layer};
}

constexpr SettingRow text_row(std::string_view table, std::string_view key,
                              std::string Settings::*field, TextKind kind, std::string_view name,
                              std::string_view help, SettingLayer last_layer) {
    return {table, key, field, {}, {}, name, "", help, last_layer, kind};
}

/// Belongs to this kiosk: its place, or what is plugged in there.
constexpr SettingRow of_kiosk(SettingRow row) {
    row.owner = SettingOwner::kiosk;
    return row;
}

constexpr auto all_rows = [] {
    using enum SettingLayer;
    return std::array{
        choice_row("feel", "mode", &Settings::mode, modes, "Kind of line",
                   "How a line feels to whoever has chosen nothing else."),
        number_row("feel", "stiffness_N_per_m", &Settings::stiffness_N_per_m, {100.0, 700.0, 50.0},
                   "Firmness", "newtons per metre",
                   "How firm lines are; a visitor’s choice is a percentage of it."),
        number_row("feel", "friction", &Settings::friction, {0.0, 1.0, 0.1}, "Friction", "",
                   "How much the handle is held back along a line."),
        number_row("feel", "force_ceiling_N", &Settings::force_ceiling_N, {0.5, 3.0, 0.1},
                   "Greatest force", "newtons",
                   "No line pushes harder. A profile may only lower it.", profile),
        number_row("feel", "capture_mm", &Settings::capture_mm, {1.0, 10.0, 0.5},
                   "Reach of a groove", "millimetres", "How far from a line it begins to pull."),
        flag_row("feel", "gives_way", &Settings::has_pop_through, "Walls give way",
                 "A long push opens a wall."),
        number_row("feel", "give_way_N", &Settings::pop_through_N, {0.5, 3.0, 0.1},
                   "Push that opens a wall", "newtons", "How hard that push has to be.", profile),
        flag_row("feel", "offers_shapes", &Settings::offers_shapes, "Shapes in the hand",
                 "Visitors may hold a shape instead of a point.", profile),
        flag_row("feel", "offers_drawing", &Settings::offers_drawing, "Drawing for visitors",
                 "Somebody may draw for a visitor, line by line.", profile),
        flag_row("levels", "automatic", &Settings::is_level_automatic, "Level follows the hand",
                 "The faster the hand, the coarser the line."),
        number_row("levels", "fixed", &Settings::fixed_level, {0.0, 16.0, 1.0}, "Fixed level", "",
                   "The level where it does not follow the hand; 0 is the finest."),
        number_row("levels", "finest", &Settings::finest_level, {0.0, 16.0, 1.0}, "Finest level",
                   "", "A level that follows the hand gets no finer.", profile),
        number_row("levels", "coarsest", &Settings::coarsest_level, {0.0, 16.0, 1.0},
                   "Coarsest level", "", "A level that follows the hand gets no coarser.", profile),
        number_row("picture", "detail", &Settings::detail, {1.0, 5.0, 1.0}, "Detail", "",
                   "1 is the silhouette alone, 5 is all there is."),
        choice_row("sound", "amount", &Settings::sounds, amounts, "Sounds",
                   "Short sounds at lines and corners, or all of them."),
        flag_row("sound", "speech", &Settings::is_speech_on, "Speech",
                 "Every visit begins with speech on or off."),
        number_row("sound", "speech_rate", &Settings::speech_rate, {1.0, 7.0, 1.0},
                   "Speaking speed", "", "1 is half as fast as 4. 7 is twice as fast."),
        text_row("language", "offered", &Settings::languages, TextKind::languages,
                 "Languages on offer", "What a visitor can choose from, in this order.", profile),
        text_row("language", "first", &Settings::first_language, TextKind::language,
                 "First language", "Every visit begins in this language.", profile),
        choice_row("language", "braille", &Settings::braille, braille_uses, "Braille display",
                   "How texts are written on a braille display that is plugged in."),
        number_row("time", "inactivity_s", &Settings::inactivity_s, {30.0, 1800.0, 30.0},
                   "Time without a key press", "seconds",
                   "After this time the kiosk asks whether somebody is there.", profile),
        number_row("time", "answer_s", &Settings::answer_s, {30.0, 300.0, 10.0}, "Time to answer",
                   "seconds", "Without an answer the visit ends after this time.", profile),
        of_kiosk(number_row("camera", "cut_left_percent", &Settings::cut_left_percent,
                            {0.0, 40.0, 2.0}, "Cut off on the left", "percent",
                            "This much of the camera’s picture is left out.", site)),
        of_kiosk(number_row("camera", "cut_right_percent", &Settings::cut_right_percent,
                            {0.0, 40.0, 2.0}, "Cut off on the right", "percent",
                            "This much of the camera’s picture is left out.", site)),
        of_kiosk(number_row("camera", "cut_top_percent", &Settings::cut_top_percent,
                            {0.0, 40.0, 2.0}, "Cut off at the top", "percent",
                            "This much of the camera’s picture is left out.", site)),
        of_kiosk(number_row("camera", "cut_bottom_percent", &Settings::cut_bottom_percent,
                            {0.0, 40.0, 2.0}, "Cut off at the bottom", "percent",
                            "This much of the camera’s picture is left out.", site)),
        flag_row("camera", "preview", &Settings::is_preview_allowed, "Live picture for companions",
                 "What lies under the camera, on the screen.", profile),
        number_row("keys", "double_strike_s", &Settings::double_strike_s, {0.0, 0.5, 0.05},
                   "Second press ignored for", "seconds",
                   "A key pressed again this soon counts only once.", profile),
        of_kiosk(choice_row("keys", "two_switches", &Settings::two_switches, switches,
                            "Two button switches",
                            "One button switch moves, the other selects; or it moves by itself.")),
        of_kiosk(number_row("keys", "scan_s", &Settings::scan_s, {0.5, 10.0, 0.5},
                            "Pace of moving by itself", "seconds",
                            "How long each item waits for the button switch.")),
        of_kiosk(number_row("screen", "viewing_distance_m", &Settings::viewing_distance_m,
                            {0.3, 3.0, 0.1}, "Distance from eyes to screen", "metres",
                            "Letters are as large as this distance needs.", site)),
        of_kiosk(number_row("screen", "size_inches", &Settings::screen_inches, {0.0, 100.0, 1.0},
                            "Size of the screen", "inches",
                            "From corner to corner; 0 is what the screen says of itself.", site)),
        choice_row("screen", "text_size", &Settings::text_size, text_sizes, "Size of letters",
                   "Four sizes; a visitor can change it."),
        choice_row("screen", "palette", &Settings::palette, palettes, "Contrast",
                   "How letters and lines differ from what is behind them."),
        text_row("hours", "opening", &Settings::opening_hours, TextKind::hours, "Opening hours",
                 "No visit begins outside these hours.", site),
        text_row("hours", "quiet", &Settings::quiet_hours, TextKind::quiet, "Quiet hours",
                 "The speaker is softer within these hours.", site),
        number_row("hours", "quiet_lower_dB", &Settings::quiet_lower_dB, {0.0, 18.0, 3.0},
                   "Softer in quiet hours", "decibels", "How much softer the speaker is then.",
                   site),
        number_row("care", "cleaning_s", &Settings::cleaning_s, {30.0, 600.0, 30.0},
                   "Time to clean the handle", "seconds", "For this long force and keys are off.",
                   site),
        of_kiosk(flag_row("care", "maintenance", &Settings::is_maintained, "Maintenance",
                          "No visit begins; a notice is said and shown.", site)),
        text_row("care", "notice", &Settings::notice, TextKind::notice, "Text of the notice",
                 "Said during maintenance. Leave it empty for the kiosk’s own text.", site),
        flag_row("care", "call_staff", &Settings::offers_staff, "Call for staff",
                 "A visitor’s list has an item that calls the staff.", site),
        flag_row("care", "counters", &Settings::counts, "Counters",
                 "Visits and pictures are counted, never people or names.", site),
        text_row("profile", "use", &Settings::profile, TextKind::name, "Profile",
                 "Its settings take priority over those of this kiosk.", site),
        of_kiosk(flag_row("stick", "more_file_systems", &Settings::more_file_systems,
                          "Read USB sticks with ext4 and NTFS too",
                          "A danger: a hostile USB stick may take the machine over.", site)),
        of_kiosk(text_row("stick", "watched_folder", &Settings::watched_folder, TextKind::path,
                          "Folder in place of a USB stick",
                          "A path, for a machine without udisks2. If empty, USB sticks are read.",
                          site)),
        of_kiosk(text_row("print", "printer", &Settings::printer, TextKind::queue,
                          "Printer for sheets to take home",
                          "Its name in CUPS. If empty, no sheets are printed.", site)),
        of_kiosk(choice_row("print", "sheet", &Settings::sheet, sheets, "Kind of sheet",
                            "Swell paper of size A4 or letter, or braille for an embosser.", site)),
        of_kiosk(choice_row("device", "make", &Settings::device_make, device_makes,
                            "Make of the device",
                            "What drives the handle, from the kiosk’s next start on.", site)),
        of_kiosk(text_row("device", "port", &Settings::device_port, TextKind::port,
                          "Port of the device",
                          "Where it is plugged in. If empty, the only one is used.", site)),
        of_kiosk(text_row("operator", "device", &Settings::operator_device, TextKind::device,
                          "Keyboard of the operator",
                          "Only its keys open these screens. If empty, any keyboard does.", site))};
}();

}  // namespace

std::span<const SettingRow> setting_rows() {
    return all_rows;
}

}  // namespace touchline
