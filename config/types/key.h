// A key as pressed, independent of any window system. Threads: constants.
#pragma once

#include <cstdint>

namespace touchline {

/// A printing key has the value of its upper-case character.
enum class Key : std::uint32_t {
    unknown = 0,
    left = 256,
    right,
    up,
    down,
    page_up,
    page_down,
    escape,
    enter,
    tab,
    backspace,
    insert,
    remove,  // Delete
    home,
    end,
    f1,
    f2,
    f3,
    f4,
    f5,
    f6,
    f7,
    f8,
    f9,
    f10,
    f11,
    f12,
    f13,  // keypads for the blind send F13 to F24
    f14,
    f15,  // some keypads with a headphone socket send this and the next
    f16,
    f17,
    f18,
    f19,
    f20,
    f21,
    f22,
    f23,
    f24,
    volume_up,
    volume_down,
    mute,
};

}  // namespace touchline
