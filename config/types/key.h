// A key as pressed, independent of any window system, and what a key means. Threads: constants.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

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

/// Each role means the same everywhere (accessibility IN-1, IN-2). The first six reach everything.
enum class KeyRole : std::uint8_t { up, down, back, repeat, select, help, louder, softer };

inline constexpr std::size_t key_role_count = 8;
inline constexpr std::size_t needed_role_count = 6;  // up ... help

/// Names in files, in the order of KeyRole.
inline constexpr std::array<std::string_view, key_role_count> key_role_names{
    "up", "down", "back", "repeat", "select", "help", "louder", "softer"};

}  // namespace touchline
