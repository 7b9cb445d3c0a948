// What an operator can set, with the values that hold where nobody set anything. Ranges, names and
// texts of each: setting_rows.h. Threads: plain values.
#pragma once

#include "config/types/hand_state.h"

#include <string>

namespace touchline {

struct Settings {
    // feel
    int mode = static_cast<int>(Mode::groove);  // Mode
    double stiffness_N_per_m = 500.0;
    double friction = 0.0;
    double capture_mm = 3.0;
    bool gives_way = false;
    double give_way_N = 1.5;  // twice what one needs to feel a line: nobody falls through by chance
    // levels
    bool is_level_automatic = true;
    int fixed_level = 0;
    double finest_level = 0.0;
    double coarsest_level = 16.0;
    // picture
    int detail = 3;
    // screen
    double viewing_distance_m = 0.6;
    // stick
    std::string watched_folder;

    friend bool operator==(const Settings&, const Settings&) = default;
};

}  // namespace touchline
