// Keys, what they mean, and which physical key has which role: the only table of keys, kept in TOML
// (config/defaults/keys.toml). Threads: values and pure functions.
#pragma once

#include "config/types/result.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// A key as pressed, independent of any window system. A printing key has the value of its
/// upper-case character.
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

/// What identifies a key: its name on the keyboard, its scancode if it has no name (volume keys on
/// some keypads), or its number on a joystick or on the handle.
enum class KeySource : std::uint8_t { key, scancode, joystick, handle };

struct PhysicalKey {
    KeySource source = KeySource::key;
    std::uint32_t code = 0;  // a Key, a scancode 1 ... 65535, a button 0 ... 255

    friend bool operator==(const PhysicalKey&, const PhysicalKey&) = default;
};

/// Returns the name as files write it: "A", "page up", "F13", "scancode 123", "joystick 2", "handle
/// 0".
[[nodiscard]] std::string name_of(const PhysicalKey& key);

/// Returns the key of that name, in any case; nothing if no key has it.
[[nodiscard]] std::optional<PhysicalKey> key_named(std::string_view name);

struct KeyBinding {
    PhysicalKey key;
    KeyRole role = KeyRole::up;

    friend bool operator==(const KeyBinding&, const KeyBinding&) = default;
};

/// Each key appears once, and each of the six needed roles has at least one key. A binding is one
/// key, never a chord.
struct KeyTable {
    std::vector<KeyBinding> bindings;  // by role, then as given

    friend bool operator==(const KeyTable&, const KeyTable&) = default;
};

/// Returns the keys of config/defaults/keys.toml.
[[nodiscard]] KeyTable default_keys();

/// O(bindings).
[[nodiscard]] std::optional<KeyRole> role_of(const KeyTable& table, const PhysicalKey& key);

/// Returns the keys of a role, in the order given.
[[nodiscard]] std::vector<PhysicalKey> keys_of(const KeyTable& table, KeyRole role);

/// Returns the first role that needs a key and has none.
[[nodiscard]] std::optional<KeyRole> role_without_key(const KeyTable& table);

/// Parses the text of a file; `name` is the file's, for the error. Malformed text, an unknown role
/// or key, a key with two roles, a chord ("A+B"), or a needed role without a key gives a one-line
/// error with file, line, and what is allowed. At most 1 MB and 64 keys a role.
[[nodiscard]] Result<KeyTable> parse_keys(std::string_view text, std::string_view name);

/// Returns text that parse_keys() reads back to the same table.
[[nodiscard]] std::string keys_text(const KeyTable& table);

}  // namespace touchline
