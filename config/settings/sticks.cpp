#include "config/settings/sticks.h"

#include <algorithm>

#include <toml++/toml.h>

namespace touchline {
namespace {

tl::unexpected<Error> wrong(std::string_view name, const toml::source_region& source,
                            std::string why) {
    std::replace(why.begin(), why.end(), '\n', ' ');
    return failure(std::string(name) + ":" + std::to_string(source.begin.line) + ": " + why);
}

Result<StickSettings> read_table(const toml::table& table, std::string_view name) {
    StickSettings settings;
    for (const auto& [key, node] : table) {
        if (key.str() != "watched_folder")
            return wrong(name, node.source(),
                         "'" + std::string(key.str()) + "' is not a setting here");
        const auto folder = node.value<std::string>();
        const bool is_path = folder && (folder->empty() || folder->front() == '/') &&
                             folder->find('\0') == std::string::npos;
        if (!is_path)
            return wrong(name, node.source(),
                         "'watched_folder' must be a path that begins with /, or \"\" for none");
        settings.watched_folder = *folder;
    }
    return settings;
}

}  // namespace

Result<StickSettings> parse_sticks(std::string_view text, std::string_view name) {
    try {
        return read_table(toml::parse(text), name);
    } catch (const toml::parse_error& error) {
        return wrong(name, error.source(), std::string(error.description()));
    }
}

}  // namespace touchline
