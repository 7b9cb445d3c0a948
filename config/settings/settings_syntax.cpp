#include "config/settings/settings_syntax.h"

#include <algorithm>
#include <optional>

namespace touchline {
namespace {

constexpr std::string_view again = " again ";  // in no name of a table

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    while (true) {
        const std::size_t end = text.find('\n');
        lines.emplace_back(text.substr(0, end));
        if (end == std::string_view::npos) return lines;
        text.remove_prefix(end + 1);
    }
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        if (&line != &lines.front()) text += '\n';
        text += line;
    }
    return text;
}

std::string_view trimmed(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

bool is_header(std::string_view line) {
    return trimmed(line).starts_with('[');
}

/// Returns what is wrong with a line by itself; nothing if it is sound.
std::optional<std::string> fault_alone(const std::string& line) {
    try {
        (void)toml::parse(line);
        return std::nullopt;
    } catch (const toml::parse_error& error) {
        return std::string(error.description());
    }
}

/// Returns whether a text of several lines begins or ends here.
bool has_long_quote(std::string_view line) {
    const auto count = [line](std::string_view quote) {
        int found = 0;
        for (std::size_t at = line.find(quote); at != std::string_view::npos;
             at = line.find(quote, at + quote.size()))
            ++found;
        return found;
    };
    return count("\"\"\"") % 2 == 1 || count("'''") % 2 == 1;
}

/// Returns the line that must change, from 0: the one where the parser stopped, unless that line is
/// sound by itself and a line above it is not, such as a text or a list that never ends.
std::size_t culprit_of(const std::vector<std::string>& lines, const toml::parse_error& error) {
    const std::size_t told = std::max<std::size_t>(error.source().begin.line, 1) - 1;
    std::size_t at = std::min(told, lines.size() - 1);
    while (at > 0 && trimmed(lines[at]).empty()) --at;
    const bool is_double = error.description().find("redefine") != std::string_view::npos;
    if (is_double || fault_alone(lines[at])) {
        if (is_double || !has_long_quote(lines[at])) return at;
    }
    for (std::size_t above = 0; above <= at; ++above)
        if (has_long_quote(lines[above])) return above;
    for (std::size_t above = at + 1; above-- > 0;)
        if (!trimmed(lines[above]).empty() && fault_alone(lines[above])) return above;
    return at;
}

/// Keys below a header belong to the table that it means, whatever is wrong with it.
std::string repaired(std::string_view line, std::size_t number) {
    if (!is_header(line)) return {};
    std::string_view name = trimmed(line);
    name.remove_prefix(std::min(name.find_first_not_of("[ \t\"'"), name.size()));
    constexpr std::string_view letters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    name = name.substr(0, name.find_first_not_of(letters));
    return "[\"" + std::string(name) + std::string(again) + std::to_string(number) + "\"]";
}

bool is_utf16(std::string_view text) {
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return true;
    return text.size() > 1 && (text[0] == '\0') != (text[1] == '\0');
}

}  // namespace

SettingsTree settings_tree(std::string_view text, std::size_t most_faults) {
    SettingsTree tree;
    if (is_utf16(text)) {
        tree.faults.push_back({1, "this is UTF-16, or no text at all; save it as UTF-8"});
        return tree;
    }
    std::string sound(text);
    std::vector<std::string> lines;
    while (true) {
        try {
            tree.table = toml::parse(sound);
            return tree;
        } catch (const toml::parse_error& error) {
            if (lines.empty()) lines = lines_of(text);
            const std::size_t at = culprit_of(lines, error);
            const auto told = fault_alone(lines[at]);
            tree.faults.push_back({at + 1, told.value_or(std::string(error.description()))});
            const std::string better = repaired(lines[at], at);
            const bool is_stuck = better == lines[at] || trimmed(lines[at]).empty();
            if (is_stuck || tree.faults.size() >= most_faults) return tree;
            lines[at] = better;
            sound = joined(lines);
        }
    }
}

std::string_view table_name(std::string_view key) {
    return key.substr(0, key.find(again));
}

}  // namespace touchline
