// Which physical key has which role: the one table of keys, kept in TOML
// (config/defaults/keys.toml). Threads: values and pure functions.
#pragma once

#include "config/types/key.h"
#include "config/types/key_role.h"
#include "config/types/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// How a key is told from others: by its name on the keyboard, by its scancode where it has none
/// (keys for volume on some keypads), or by its number on a joystick or on the handle.
enum class KeySource : std::uint8_t { key, scancode, joystick, handle };

struct PhysicalKey {
    KeySource source = KeySource::key;
    std::uint32_t code = 0;  // a Key, a scancode 1 ... 65535, a button 0 ... 255

    friend bool operator==(const PhysicalKey&, const PhysicalKey&) = default;
};

/// As files write it: "A", "page up", "F13", "scancode 123", "joystick 2", "handle 0".
[[nodiscard]] std::string name_of(const PhysicalKey& key);

/// The key of that name, in any case; nothing for a name that no key has.
[[nodiscard]] std::optional<PhysicalKey> key_named(std::string_view name);

struct KeyBinding {
    PhysicalKey key;
    KeyRole role = KeyRole::up;

    friend bool operator==(const KeyBinding&, const KeyBinding&) = default;
};

/// A key is in it once; the six needed roles have a key each at least. No chords: a binding is one
/// key.
struct KeyTable {
    std::vector<KeyBinding> bindings;  // by role, then as given

    friend bool operator==(const KeyTable&, const KeyTable&) = default;
};

/// Those of config/defaults/keys.toml.
[[nodiscard]] KeyTable default_keys();

/// O(bindings).
[[nodiscard]] std::optional<KeyRole> role_of(const KeyTable& table, const PhysicalKey& key);

/// The keys of a role, first given first.
[[nodiscard]] std::vector<PhysicalKey> keys_of(const KeyTable& table, KeyRole role);

/// The first role without a key that needs one.
[[nodiscard]] std::optional<KeyRole> role_without_key(const KeyTable& table);

/// What the text of a file holds; `name` is that file's, for the error. Malformed, an unknown role
/// or key, a key with two roles, a chord ("A+B"), a needed role without a key: one line with file,
/// line, and what is allowed. At most 1 MB and 64 keys a role.
[[nodiscard]] Result<KeyTable> parse_keys(std::string_view text, std::string_view name);

/// The text that parse_keys() reads back to the same table.
[[nodiscard]] std::string keys_text(const KeyTable& table);

}  // namespace touchline
