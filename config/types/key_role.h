// What a key means, whichever key it is. Threads: constants.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace touchline {

/// Each role means the same everywhere (accessibility IN-1, IN-2). The first six reach everything.
enum class KeyRole : std::uint8_t { up, down, back, repeat, select, help, louder, softer };

inline constexpr std::size_t key_role_count = 8;
inline constexpr std::size_t needed_role_count = 6;  // up ... help

/// Names in files, in the order of KeyRole.
inline constexpr std::array<std::string_view, key_role_count> key_role_names{
    "up", "down", "back", "repeat", "select", "help", "louder", "softer"};

}  // namespace touchline
