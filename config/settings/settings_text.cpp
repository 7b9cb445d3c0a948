#include "config/settings/settings_text.h"

#include "config/types/utf8.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <sstream>

#include <toml++/toml.h>

namespace touchline {
namespace {

struct SettingFault {
    std::size_t line = 0;  // in the text, from 1; 0: the text as a whole
    std::string words;     // one line
};

struct SettingsTree {
    toml::table table;                 // from the sound lines
    std::vector<SettingFault> faults;  // in the other lines
};

constexpr std::string_view again = " again ";  // in no name of a table
constexpr std::string_view blanks = " \t\r";

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

bool is_header(std::string_view line) {
    return trimmed(line, blanks).starts_with('[');
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
    while (at > 0 && trimmed(lines[at], blanks).empty()) --at;
    const bool is_double = error.description().find("redefine") != std::string_view::npos;
    if (is_double || fault_alone(lines[at])) {
        if (is_double || !has_long_quote(lines[at])) return at;
    }
    for (std::size_t above = 0; above <= at; ++above)
        if (has_long_quote(lines[above])) return above;
    for (std::size_t above = at + 1; above-- > 0;)
        if (!trimmed(lines[above], blanks).empty() && fault_alone(lines[above])) return above;
    return at;
}

/// Keys below a header belong to the table that it means, whatever is wrong with it.
std::string repaired(std::string_view line, std::size_t number) {
    if (!is_header(line)) return {};
    std::string_view name = trimmed(line, blanks);
    name.remove_prefix(std::min(name.find_first_not_of("[ \t\"'"), name.size()));
    constexpr std::string_view letters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    name = name.substr(0, name.find_first_not_of(letters));
    return "[\"" + std::string(name) + std::string(again) + std::to_string(number) + "\"]";
}

/// Finds at most `most_faults` (>= 1) faults, and reads nothing after the last one. A table that is
/// begun twice is in the tree under two names; table_name() returns the one that was meant. O(text)
/// a fault.
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
            const bool is_stuck = better == lines[at] || trimmed(lines[at], blanks).empty();
            if (is_stuck || tree.faults.size() >= most_faults) return tree;
            lines[at] = better;
            sound = joined(lines);
        }
    }
}

/// Returns the name of a table of the tree as it is in the text.
std::string_view table_name(std::string_view key) {
    return key.substr(0, key.find(again));
}

constexpr std::size_t most_faults_told = 100;

std::string line_of(std::string_view name, const SettingFault& fault) {
    return line_in_file(name, fault.line, fault.words);
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

bool is_known_table(std::string_view table) {
    const auto rows = setting_rows();
    return std::any_of(rows.begin(), rows.end(),
                       [&](const SettingRow& row) { return row.table == table; });
}

/// Judges a file: collects its sound settings and all its faults.
class Judge {
  public:
    Judge(const Settings& base, SettingLayer layer) : base_(base), settings_(base), layer_(layer) {}

    void read(const toml::table& file) {
        for (const auto& [key, node] : file) read_table(table_name(key.str()), node);
    }

    /// Finds contradictions between the sound ones.
    void compare() {
        for (const SettingConflict& conflict : conflicts(settings_))
            fault(std::max(line_of(conflict.one), line_of(conflict.other)), conflict.sentence);
        if (layer_ <= SettingLayer::site) return;
        const std::string why = trespass(base_, settings_);
        if (!why.empty()) fault(line_of("feel.force_ceiling_N"), why);
    }

    /// `languages` holds the codes of the existing languages; if empty, they are not checked.
    void ask_for(std::span<const std::string> languages) {
        if (languages.empty()) return;
        const auto wanted = languages_in_text(settings_.languages);
        if (!wanted) return;
        for (const std::string& code : *wanted)
            if (std::ranges::count(languages, code) == 0)
                fault(line_of("language.offered"), "'language.offered': there are no words of '" +
                                                       code + "'; there are those of " +
                                                       together(languages));
    }

    void add(std::vector<SettingFault> faults) {
        faults_.insert(faults_.end(), faults.begin(), faults.end());
    }

    /// Returns the faults in the order of the lines.
    std::vector<SettingFault> take_faults() {
        std::ranges::stable_sort(faults_, {}, &SettingFault::line);
        return std::move(faults_);
    }

    [[nodiscard]] const Settings& settings() const { return settings_; }

  private:
    static std::string together(std::span<const std::string> words) {
        std::string text;
        for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
        return text;
    }

    void fault(std::size_t line, std::string words) { faults_.push_back({line, std::move(words)}); }

    void read_table(std::string_view table, const toml::node& node) {
        const std::size_t line = node.source().begin.line;
        if (!is_known_table(table) || !node.is_table())
            return fault(line, '\'' + std::string(table) + "' is no table of settings");
        for (const auto& [key, value] : *node.as_table()) read_key(table, key.str(), value);
    }

    void read_key(std::string_view table, std::string_view key, const toml::node& node) {
        const std::size_t line = node.source().begin.line;
        const std::string name = quoted(table, key);
        const SettingRow* row = find_setting(table, key);
        if (row == nullptr) return fault(line, name + " is not a setting");
        if (layer_ > row->last_layer)
            return fault(
                line, name + " can be set by " + std::string(name_of(row->last_layer)) + " only");
        const auto [at, is_first] = lines_.emplace(name.substr(1, name.size() - 2), line);
        if (!is_first)
            return fault(line, name + " is set in line " + std::to_string(at->second) + " already");
        const auto value = value_in(node);
        auto changed = value ? with_value(settings_, *row, *value) : std::nullopt;
        if (!changed) return fault(line, name + " must be " + allowed_values(*row));
        settings_ = std::move(*changed);
    }

    /// Returns 0 for a key that the file does not set.
    [[nodiscard]] std::size_t line_of(std::string_view key) const {
        const auto at = lines_.find(key);
        return at == lines_.end() ? 0 : at->second;
    }

    const Settings& base_;
    Settings settings_;
    SettingLayer layer_;
    std::map<std::string, std::size_t, std::less<>> lines_;  // of the keys
    std::vector<SettingFault> faults_;
};

std::vector<SettingFault> too_large(std::string_view text) {
    if (text.size() <= largest_settings_bytes) return {};
    return {{0, "is larger than 1 MB; no file of settings is"}};
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

std::string line_in_file(std::string_view name, std::size_t line, std::string words) {
    std::replace(words.begin(), words.end(), '\n', ' ');
    const std::string place = line == 0 ? "" : ':' + std::to_string(line);
    return std::string(name) + place + ": " + words;
}

Result<std::string> read_settings_file(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) return failure("cannot read " + file.string());
    std::string text(largest_settings_bytes + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (in.bad()) return failure("cannot read " + file.string());
    text.resize(static_cast<std::size_t>(in.gcount()));
    if (text.size() > largest_settings_bytes)
        return failure(file.string() + " is larger than 1 MB");
    return text;
}

Result<Settings> apply_settings(const Settings& base, std::string_view text, std::string_view name,
                                SettingLayer layer) {
    auto faults = too_large(text);
    if (!faults.empty()) return failure(line_of(name, faults.front()));
    SettingsTree tree = settings_tree(text, 1);
    if (!tree.faults.empty()) return failure(line_of(name, tree.faults.front()));
    Judge judge(base, layer);
    judge.read(tree.table);
    faults = judge.take_faults();
    if (faults.empty()) {
        judge.compare();
        faults = judge.take_faults();
    }
    if (!faults.empty()) return failure(line_of(name, faults.front()));
    return judge.settings();
}

std::vector<std::string> settings_faults(std::string_view text, std::string_view name,
                                         SettingLayer layer,
                                         std::span<const std::string> languages) {
    auto faults = too_large(text);
    if (faults.empty()) {
        SettingsTree tree = settings_tree(text, most_faults_told);
        const Settings base;
        Judge judge(base, layer);
        judge.read(tree.table);
        judge.compare();
        judge.ask_for(languages);
        judge.add(std::move(tree.faults));
        faults = judge.take_faults();
    }
    std::vector<std::string> lines;
    for (const SettingFault& fault : faults) {
        if (lines.size() == most_faults_told) {
            lines.push_back(std::string(name) + ": there is more; correct these first");
            break;
        }
        lines.push_back(line_of(name, fault));
    }
    return lines;
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
