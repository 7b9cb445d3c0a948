#include "config/settings/settings_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <sstream>

#include <toml++/toml.h>

namespace touchline {
namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 20U;

tl::unexpected<Error> wrong(std::string_view name, const toml::source_region& source,
                            std::string why) {
    std::replace(why.begin(), why.end(), '\n', ' ');
    return failure(std::string(name) + ":" + std::to_string(source.begin.line) + ": " + why);
}

std::optional<SettingValue> value_in(const toml::node& node) {
    if (const auto* is_on = node.as_boolean()) return is_on->get();
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
    if (const auto* number = node.as_floating_point()) return number->get();
    return std::nullopt;
}

std::string quoted(std::string_view table, std::string_view key) {
    return '\'' + std::string(table) + '.' + std::string(key) + '\'';
}

std::string_view name_of(SettingLayer layer) {
    constexpr std::array<std::string_view, 4> names{"the program", "the site's file", "a profile",
                                                    "a visit"};
    return names[static_cast<std::size_t>(layer)];
}

struct Reader {
    std::string_view name;
    SettingLayer layer;

    [[nodiscard]] Result<Settings> read_key(const Settings& base, std::string_view table,
                                            std::string_view key, const toml::node& node) const {
        const SettingRow* row = find_setting(table, key);
        if (row == nullptr)
            return wrong(name, node.source(), quoted(table, key) + " is not a setting");
        if (layer > row->last_layer)
            return wrong(name, node.source(),
                         quoted(table, key) + " can be set by " +
                             std::string(name_of(row->last_layer)) + " only");
        const auto value = value_in(node);
        const auto changed = value ? with_value(base, *row, *value) : std::nullopt;
        if (changed) return *changed;
        return wrong(name, node.source(), quoted(table, key) + " must be " + allowed_values(*row));
    }

    [[nodiscard]] Result<Settings> read_table(Settings settings, std::string_view table,
                                              const toml::node& node) const {
        if (!node.is_table())
            return wrong(name, node.source(),
                         '\'' + std::string(table) + "' is no table of settings");
        for (const auto& [key, value] : *node.as_table()) {
            auto changed = read_key(settings, table, key.str(), value);
            if (!changed) return changed;
            settings = std::move(*changed);
        }
        return settings;
    }
};

bool is_known_table(std::string_view table) {
    const auto rows = setting_rows();
    return std::any_of(rows.begin(), rows.end(),
                       [&](const SettingRow& row) { return row.table == table; });
}

Result<Settings> apply(const Settings& base, const toml::table& file, const Reader& reader) {
    Settings settings = base;
    for (const auto& [table, node] : file) {
        if (!is_known_table(table.str()))
            return wrong(reader.name, node.source(),
                         '\'' + std::string(table.str()) + "' is no table of settings");
        auto changed = reader.read_table(std::move(settings), table.str(), node);
        if (!changed) return changed;
        settings = std::move(*changed);
    }
    std::string why = contradiction(settings);
    if (why.empty() && reader.layer > SettingLayer::site) why = trespass(base, settings);
    if (!why.empty()) return failure(std::string(reader.name) + ": " + why);
    return settings;
}

std::string in_toml(const SettingValue& value) {
    if (const double* number = std::get_if<double>(&value)) {
        std::array<char, 32> shortest{};
        const auto [end, error] = std::to_chars(shortest.begin(), shortest.end(), *number);
        return {shortest.begin(), end};
    }
    std::ostringstream text;
    std::visit([&text](const auto& plain) { text << toml::value(plain); }, value);
    return text.str();
}

std::string written(const Settings& settings, const Settings* base) {
    std::string text;
    std::string_view table;
    for (const SettingRow& row : setting_rows()) {
        const SettingValue value = value_of(settings, row);
        if (base != nullptr && value == value_of(*base, row)) continue;
        if (row.table != table) {
            text += (text.empty() ? "[" : "\n[") + std::string(row.table) + "]\n";
            table = row.table;
        }
        text += "# " + std::string(row.help) + " Allowed: " + allowed_values(row) + ".\n" +
                std::string(row.key) + " = " + in_toml(value) + '\n';
    }
    return text;
}

}  // namespace

Result<Settings> apply_settings(const Settings& base, std::string_view text, std::string_view name,
                                SettingLayer layer) {
    if (text.size() > most_bytes)
        return failure(std::string(name) + ": is larger than 1 MB; no file of settings is");
    try {
        return apply(base, toml::parse(text), {name, layer});
    } catch (const toml::parse_error& error) {
        return wrong(name, error.source(), std::string(error.description()));
    }
}

std::vector<std::size_t> rows_in(std::string_view text) {
    std::vector<std::size_t> found;
    try {
        const toml::table file = toml::parse(text);
        const auto rows = setting_rows();
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (file[rows[i].table][rows[i].key]) found.push_back(i);
    } catch (const toml::parse_error&) {
        found.clear();
    }
    return found;
}

std::string settings_text(const Settings& settings, const Settings& base) {
    return written(settings, &base);
}

std::string settings_text(const Settings& settings) {
    return written(settings, nullptr);
}

}  // namespace touchline
