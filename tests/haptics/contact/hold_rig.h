// What the tests of the contact machine share.
#pragma once

#include "haptics/contact/contact_machine.h"
#include "tests/haptics/tick.h"

#include <array>

namespace touchline {

inline constexpr std::array all_modes{Mode::wall, Mode::groove, Mode::ridge, Mode::stay};
inline constexpr std::array hold_modes{Mode::groove, Mode::ridge, Mode::stay};

inline Scene scene_of(const TactileMap& map, double radius_m = 0.0) {
    return build_scene(map, {}, radius_m).value();
}

inline ContactSettings settings_of(Mode mode) {
    ContactSettings settings;
    settings.mode = mode;
    return settings;
}

}  // namespace touchline
