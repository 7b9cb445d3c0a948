// What an operator can set, with the default values. Ranges, names and texts of each:
// setting_rows.h. Threads: plain values.
#pragma once

#include "config/types/choices.h"
#include "config/types/hand_state.h"

#include <string>

namespace touchline {

struct Settings {
    // feel
    Mode mode = Mode::groove;  // of a visitor who has chosen none
    double stiffness_N_per_m = 500.0;
    double friction = 0.0;
    double force_ceiling_N = 3.0;
    double capture_mm = 3.0;
    bool has_pop_through = false;
    double pop_through_N =
        1.5;  // twice the force needed to feel a line: nobody falls through by chance
    bool offers_shapes = false;   // a visitor may hold a shape instead of a point
    bool offers_drawing = false;  // somebody may draw for a visitor
    // levels
    bool is_level_automatic = true;
    int fixed_level = 0;
    double finest_level = 0.0;
    double coarsest_level = 16.0;
    // picture
    int detail = 3;
    // sound
    CueAmount sounds = CueAmount::cues;
    bool is_speech_on = true;
    int speech_rate = 4;  // 1 ... 7: a step of speech_rates_per_minute, counted from 1
    // language
    std::string languages = "en de fr es it";  // codes, in the order in which they are offered
    std::string first_language = "en";         // one of them
    BrailleUse braille = BrailleUse::uncontracted;
    // time
    double inactivity_s = 90.0;
    double answer_s = 30.0;
    // camera
    double cut_left_percent = 0.0;
    double cut_right_percent = 0.0;
    double cut_top_percent = 0.0;
    double cut_bottom_percent = 0.0;
    bool is_preview_allowed = true;
    // keys
    double double_strike_s = 0.1;
    SwitchUse two_switches = SwitchUse::none;
    double scan_s = 2.0;
    // screen
    double viewing_distance_m = 0.6;
    double screen_inches = 0.0;  // diagonal; 0: as the screen reports
    TextSize text_size = TextSize::normal;
    PaletteName palette = PaletteName::white_on_black;
    // hours
    std::string opening_hours = "00:00-24:00";
    std::string quiet_hours;
    double quiet_lower_dB = 6.0;
    // care
    double cleaning_s = 60.0;
    bool is_maintained = false;  // nobody can begin a visit
    std::string notice;
    bool offers_staff = true;
    bool counts = true;
    // profile
    std::string profile;  // its name; empty: none
    // stick
    bool more_file_systems = false;  // ext4 and NTFS besides FAT and exFAT
    std::string watched_folder;
    // print
    std::string printer;  // a queue of CUPS; empty: no sheets to take home
    SheetKind sheet = SheetKind::a4;
    // device
    DeviceMake device_make = DeviceMake::usb_board;
    std::string device_port;  // empty: the only one
    // operator
    std::string operator_device;

    friend bool operator==(const Settings&, const Settings&) = default;
};

}  // namespace touchline
