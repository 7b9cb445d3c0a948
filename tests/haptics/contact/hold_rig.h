// What the tests of groove, ridge and stay share.
#pragma once

#include "haptics/contact/contact_machine.h"

#include <array>

namespace touchline {

inline constexpr double tick_s = 1e-3;
inline constexpr std::array hold_modes{Mode::groove, Mode::ridge, Mode::stay};

inline Scene scene_of(const TactileMap& map) {
    return build_scene(map, {}, 0.0).value();
}

inline ContactSettings settings_of(Mode mode) {
    ContactSettings settings;
    settings.mode = mode;
    return settings;
}

}  // namespace touchline
