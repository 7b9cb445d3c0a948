#include "config/settings/keys.h"

#include "config/settings/settings_text.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <cctype>

#include <toml++/toml.h>

namespace touchline {
namespace {

constexpr std::size_t most_keys = 64;  // per role

struct NamedKey {
    std::string_view name;
    Key key;
};

constexpr std::array named_keys{
    NamedKey{"left", Key::left},
    NamedKey{"right", Key::right},
    NamedKey{"up", Key::up},
    NamedKey{"down", Key::down},
    NamedKey{"page up", Key::page_up},
    NamedKey{"page down", Key::page_down},
    NamedKey{"escape", Key::escape},
    NamedKey{"enter", Key::enter},
    NamedKey{"tab", Key::tab},
    NamedKey{"backspace", Key::backspace},
    NamedKey{"insert", Key::insert},
    NamedKey{"delete", Key::remove},
    NamedKey{"home", Key::home},
    NamedKey{"end", Key::end},
    NamedKey{"volume up", Key::volume_up},
    NamedKey{"volume down", Key::volume_down},
    NamedKey{"mute", Key::mute},
    NamedKey{"space", Key{' '}},
    NamedKey{"minus", Key{'-'}},
    NamedKey{"equals", Key{'='}},
    NamedKey{"comma", Key{','}},
    NamedKey{"full stop", Key{'.'}},
    NamedKey{"plus", Key{'+'}},
};

struct NumberedSource {
    std::string_view name;  // before the number
    KeySource source;
    std::uint32_t least;
    std::uint32_t most;
};

constexpr std::array numbered{
    NumberedSource{"scancode ", KeySource::scancode, 1, 65535},
    NumberedSource{"joystick ", KeySource::joystick, 0, 255},
    NumberedSource{"handle ", KeySource::handle, 0, 255},
};

constexpr std::string_view what_keys_are =
    "a letter, a digit, \"up\", \"page up\", \"enter\", \"space\", \"F13\", \"volume up\", "
    "\"scancode 123\", \"joystick 0\" or \"handle 0\"";

constexpr std::uint32_t first_function_key = static_cast<std::uint32_t>(Key::f1);
constexpr std::uint32_t function_keys = 24;
static_assert(static_cast<std::uint32_t>(Key::f24) == first_function_key + function_keys - 1);

std::optional<PhysicalKey> function_key(std::string_view name) {
    if (name.size() < 2 || name.front() != 'f') return std::nullopt;
    const auto number = number_in<std::uint32_t>(name.substr(1), 1, function_keys);
    if (!number) return std::nullopt;
    return PhysicalKey{KeySource::key, first_function_key + *number - 1};
}

std::optional<PhysicalKey> numbered_key(std::string_view name) {
    for (const NumberedSource& kind : numbered) {
        if (!name.starts_with(kind.name)) continue;
        const auto number =
            number_in<std::uint32_t>(name.substr(kind.name.size()), kind.least, kind.most);
        if (number) return PhysicalKey{kind.source, *number};
    }
    return std::nullopt;
}

bool prints(std::uint32_t code) {
    constexpr std::uint32_t last_ascii = 127;
    return code > ' ' && code < last_ascii;
}

std::string name_of_key(std::uint32_t code) {
    for (const NamedKey& named : named_keys)
        if (static_cast<std::uint32_t>(named.key) == code) return std::string(named.name);
    if (code >= first_function_key && code < first_function_key + function_keys)
        return "F" + std::to_string(code - first_function_key + 1);
    if (prints(code)) return std::string(1, static_cast<char>(code));
    return "unknown";
}

tl::unexpected<Error> wrong(std::string_view name, const toml::source_region& source,
                            std::string why) {
    return failure(line_in_file(name, source.begin.line, std::move(why)));
}

std::string roles_in_words() {
    std::string text;
    for (const std::string_view role : key_role_names)
        text += (text.empty() ? "" : ", ") + std::string(role);
    return text;
}

std::optional<KeyRole> role_named(std::string_view name) {
    const auto found = std::find(key_role_names.begin(), key_role_names.end(), name);
    if (found == key_role_names.end()) return std::nullopt;
    return static_cast<KeyRole>(found - key_role_names.begin());
}

std::string name_of_role(KeyRole role) {
    return std::string(key_role_names[static_cast<std::size_t>(role)]);
}

struct Reader {
    std::string_view name;
    KeyTable table;

    [[nodiscard]] Result<void> read_key(KeyRole role, const toml::node& node) {
        const auto* const text = node.as_string();
        const auto key = text != nullptr ? key_named(text->get()) : std::nullopt;
        const std::string said = text != nullptr ? '\'' + text->get() + '\'' : "this";
        if (!key) {
            const bool is_chord = text != nullptr && text->get().find('+') != std::string::npos;
            return wrong(name, node.source(),
                         is_chord ? said + " is a chord; a role has single keys only"
                                  : said + " is no key; a key is " + std::string(what_keys_are));
        }
        if (const auto other = role_of(table, *key))
            return wrong(name, node.source(),
                         said + " has the role '" + name_of_role(*other) + "' already");
        table.bindings.push_back({*key, role});
        return {};
    }

    [[nodiscard]] Result<void> read_role(std::string_view role_name, const toml::node& node) {
        const auto role = role_named(role_name);
        if (!role)
            return wrong(
                name, node.source(),
                '\'' + std::string(role_name) + "' is no role; the roles are: " + roles_in_words());
        const auto* const keys = node.as_array();
        if (keys == nullptr || keys->size() > most_keys)
            return wrong(name, node.source(),
                         '\'' + std::string(role_name) + "' must be a list of at most 64 keys");
        for (const toml::node& key : *keys) {
            auto read = read_key(*role, key);
            if (!read) return read;
        }
        return {};
    }

    [[nodiscard]] Result<KeyTable> read(const toml::table& file) {
        for (const auto& [role, node] : file) {
            const auto read = read_role(role.str(), node);
            if (!read) return tl::unexpected(read.error());
        }
        if (const auto role = role_without_key(table))
            return failure(std::string(name) + ": the role '" + name_of_role(*role) +
                           "' has no key; give it one");
        std::stable_sort(table.bindings.begin(), table.bindings.end(),
                         [](const KeyBinding& a, const KeyBinding& b) { return a.role < b.role; });
        return table;
    }
};

/// config/defaults/keys.toml, compiled in, so that the kiosk has keys whatever happened to its
/// files.
struct KeysOfRole {
    KeyRole role;
    std::array<std::string_view, 5> names;  // empty after the last
};

constexpr std::array default_names{
    KeysOfRole{KeyRole::up, {"up", "F17", "joystick 0"}},
    KeysOfRole{KeyRole::down, {"down", "F18", "joystick 1"}},
    KeysOfRole{KeyRole::back, {"left", "escape", "F19", "joystick 2"}},
    KeysOfRole{KeyRole::repeat, {"right", "F20", "joystick 3"}},
    KeysOfRole{KeyRole::select, {"enter", "space", "F21", "joystick 4", "handle 0"}},
    KeysOfRole{KeyRole::help, {"H", "F1", "F22", "joystick 5"}},
    KeysOfRole{KeyRole::louder, {"equals", "plus", "volume up", "F23", "scancode 123"}},
    KeysOfRole{KeyRole::softer, {"minus", "volume down", "F24", "scancode 122"}},
};

}  // namespace

std::string name_of(const PhysicalKey& key) {
    if (key.source == KeySource::key) return name_of_key(key.code);
    const auto* const kind = std::find_if(
        numbered.begin(), numbered.end(),
        [&](const NumberedSource& candidate) { return candidate.source == key.source; });
    return std::string(kind->name) + std::to_string(key.code);
}

std::optional<PhysicalKey> key_named(std::string_view name) {
    const std::string small = in_small_letters(name);
    for (const NamedKey& named : named_keys)
        if (named.name == small)
            return PhysicalKey{KeySource::key, static_cast<std::uint32_t>(named.key)};
    if (small.size() == 1 && prints(static_cast<unsigned char>(small.front())))
        return PhysicalKey{
            KeySource::key,
            static_cast<std::uint32_t>(std::toupper(static_cast<unsigned char>(small.front())))};
    if (const auto key = function_key(small)) return key;
    return numbered_key(small);
}

KeyTable default_keys() {
    KeyTable table;
    for (const auto& [role, names] : default_names)
        for (const std::string_view name : names)
            if (const auto key = key_named(name)) table.bindings.push_back({*key, role});
    return table;
}

std::optional<KeyRole> role_of(const KeyTable& table, const PhysicalKey& key) {
    for (const KeyBinding& binding : table.bindings)
        if (binding.key == key) return binding.role;
    return std::nullopt;
}

std::vector<PhysicalKey> keys_of(const KeyTable& table, KeyRole role) {
    std::vector<PhysicalKey> keys;
    for (const KeyBinding& binding : table.bindings)
        if (binding.role == role) keys.push_back(binding.key);
    return keys;
}

std::optional<KeyRole> role_without_key(const KeyTable& table) {
    for (std::size_t i = 0; i < needed_role_count; ++i)
        if (keys_of(table, static_cast<KeyRole>(i)).empty()) return static_cast<KeyRole>(i);
    return std::nullopt;
}

Result<KeyTable> parse_keys(std::string_view text, std::string_view name) {
    if (text.size() > largest_settings_bytes)
        return failure(std::string(name) + ": is larger than 1 MB; no table of keys is");
    try {
        return Reader{name, {}}.read(toml::parse(text));
    } catch (const toml::parse_error& error) {
        return wrong(name, error.source(), std::string(error.description()));
    }
}

std::string keys_text(const KeyTable& table) {
    std::string text;
    for (std::size_t i = 0; i < key_role_count; ++i) {
        const auto keys = keys_of(table, static_cast<KeyRole>(i));
        if (keys.empty()) continue;
        text += std::string(key_role_names[i]) + " = [";
        for (std::size_t k = 0; k < keys.size(); ++k) {
            const std::string key = name_of(keys[k]);
            const char quote = key == "'" ? '"' : '\'';  // TOML's literal texts hold no quote
            text += (k == 0 ? "" : ", ") + (quote + key + quote);
        }
        text += "]\n";
    }
    return text;
}

}  // namespace touchline
