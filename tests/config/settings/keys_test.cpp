// Tests the table of keys: every name, every wrong file, and the rules IN-1 and IN-3 for the
// installed keys.
#include "config/settings/keys.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

std::string installed() {
    std::ifstream in(TOUCHLINE_SOURCE_DIR "/config/defaults/keys.toml");
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string keys_error(const std::string& text) {
    const auto keys = parse_keys(text, "keys.toml");
    return keys ? "no error" : keys.error().line;
}

TEST(Keys, EveryNameIsReadBack) {
    for (std::uint32_t code = '!'; code <= static_cast<std::uint32_t>(Key::mute); ++code) {
        const bool is_small_letter = code >= 'a' && code <= 'z';
        const bool is_hole = code > '~' && code < static_cast<std::uint32_t>(Key::left);
        if (is_small_letter || is_hole) continue;
        const PhysicalKey key{KeySource::key, code};
        EXPECT_EQ(key_named(name_of(key)), key) << name_of(key);
    }
    for (const PhysicalKey& key :
         {PhysicalKey{KeySource::scancode, 1}, PhysicalKey{KeySource::scancode, 65535},
          PhysicalKey{KeySource::joystick, 0}, PhysicalKey{KeySource::handle, 255}})
        EXPECT_EQ(key_named(name_of(key)), key) << name_of(key);
    EXPECT_EQ(key_named("h"), key_named("H"));
    EXPECT_EQ(key_named("Page Up"), key_named("page up"));
    for (const char* name : {"", "f0", "F25", "scancode 0", "scancode 65536", "joystick -1",
                             "handle", "joystick 256", "scancode 1x", "ctrl", "A+B"})
        EXPECT_FALSE(key_named(name)) << name;
}

TEST(Keys, WhatIsInstalledIsWhatIsCompiledIn) {
    const auto keys = parse_keys(installed(), "keys.toml");
    ASSERT_TRUE(keys) << keys.error().line;
    EXPECT_EQ(*keys, default_keys());
    EXPECT_NE(installed().find(keys_text(default_keys())), std::string::npos);
}

/// IN-1, IN-3: one key for each role, on a keyboard and on a keypad; the handle can also Select.
TEST(Keys, EachRoleIsOneKeyOfEachKindOfDevice) {
    const KeyTable keys = default_keys();
    EXPECT_FALSE(role_without_key(keys));
    for (std::size_t i = 0; i < needed_role_count; ++i) {
        const auto role = static_cast<KeyRole>(i);
        bool is_on_keypad = false;
        bool is_on_joystick = false;
        for (const PhysicalKey& key : keys_of(keys, role)) {
            const bool is_function = key.source == KeySource::key &&
                                     key.code >= static_cast<std::uint32_t>(Key::f13) &&
                                     key.code <= static_cast<std::uint32_t>(Key::f24);
            is_on_keypad = is_on_keypad || is_function;
            is_on_joystick = is_on_joystick || key.source == KeySource::joystick;
        }
        EXPECT_TRUE(is_on_keypad) << key_role_names[i];
        EXPECT_TRUE(is_on_joystick) << key_role_names[i];
    }
    EXPECT_EQ(role_of(keys, {KeySource::handle, 0}), KeyRole::select);
    for (const Key headphones : {Key::f15, Key::f16})
        EXPECT_FALSE(role_of(keys, {KeySource::key, static_cast<std::uint32_t>(headphones)}));
}

TEST(Keys, WhateverIsWrongIsOneLineWithItsPlace) {
    EXPECT_EQ(keys_error("up = ['ctrl+A']"),
              "keys.toml:1: 'ctrl+A' is a chord; a role has single keys only");
    EXPECT_TRUE(
        keys_error("\nup = ['sideways']").starts_with("keys.toml:2: 'sideways' is no key; "));
    EXPECT_EQ(keys_error("up = ['A']\ndown = ['a']"),
              "keys.toml:1: 'A' has the role 'down' already");
    EXPECT_TRUE(keys_error("upp = ['A']")
                    .starts_with("keys.toml:1: 'upp' is no role; the roles are: "
                                 "up, down, back"));
    EXPECT_EQ(keys_error("up = 'A'"), "keys.toml:1: 'up' must be a list of at most 64 keys");
    EXPECT_TRUE(keys_error("up = [3]").starts_with("keys.toml:1: this is no key; "));
    EXPECT_EQ(keys_error("up = ['A']"), "keys.toml: the role 'down' has no key; give it one");
    EXPECT_EQ(keys_error(""), "keys.toml: the role 'up' has no key; give it one");
    EXPECT_TRUE(keys_error("up = ['A'").starts_with("keys.toml:1: "));
    EXPECT_EQ(keys_error(std::string(2'000'000, '#')),
              "keys.toml: is larger than 1 MB; no table of keys is");
}

TEST(Keys, CutOffAnywhereIsOneLineOrWhole) {
    const std::string whole = keys_text(default_keys());
    const std::size_t needed = whole.find("louder");
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const auto keys = parse_keys(whole.substr(0, length), "f");
        if (keys) {
            EXPECT_GE(length + 1, needed);
            EXPECT_FALSE(role_without_key(*keys));
        } else {
            EXPECT_TRUE(keys.error().line.starts_with("f:"));
            EXPECT_EQ(keys.error().line.find('\n'), std::string::npos);
        }
    }
}

RC_GTEST_PROP(Keys, AnyTableIsReadBack, ()) {
    KeyTable table = default_keys();
    const auto codes = *rc::gen::container<std::set<std::uint32_t>>(rc::gen::inRange(1U, 60000U));
    for (const std::uint32_t code : codes)
        if (!role_of(table, {KeySource::scancode, code}) && table.bindings.size() < 60)
            table.bindings.push_back(
                {{KeySource::scancode, code}, static_cast<KeyRole>(code % key_role_count)});
    std::stable_sort(table.bindings.begin(), table.bindings.end(),
                     [](const KeyBinding& a, const KeyBinding& b) { return a.role < b.role; });
    const auto read = parse_keys(keys_text(table), "f");
    RC_ASSERT(read.has_value());
    RC_ASSERT(*read == table);
}

}  // namespace
}  // namespace touchline
