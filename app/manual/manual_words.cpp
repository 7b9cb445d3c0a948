#include "app/manual/manual_words.h"

#include "app/operator/setting_words.h"

#include <array>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr std::string_view settings_line = "<!-- settings -->";

std::string said(const Language& language, const std::string& english,
                 std::initializer_list<std::string_view> values = {}) {
    return language.text("manual", english, values);
}

/// As it is written in the file, followed by what the kiosk says instead.
std::string choice(std::string_view written, const std::string& said) {
    return written == said ? fmt::format("\"{}\"", written)
                           : fmt::format("\"{}\" ({})", written, said);
}

std::string who_sets(SettingLayer last, const Language& language) {
    switch (last) {
        case SettingLayer::profile:
            return said(language, "The file of this kiosk and a profile set it.");
        case SettingLayer::session:
            return said(language,
                        "The file and a profile set it; a visitor may change it for the visit.");
        default:
            return said(language, "Only the file of this kiosk sets it.");
    }
}

std::string paragraphs_of(const SettingRow& row, const Language& language) {
    const std::string key = fmt::format("`{}.{}`", row.table, row.key);
    return fmt::format("#### {}\n\n{}\n\n{} {} {}\n\n", setting_name(row, language),
                       setting_help(row, language),
                       said(language, "{0} is {1}.", {key, allowed_values(row, language)}),
                       said(language, "At first: {0}.", {setting_value(Settings{}, row, language)}),
                       who_sets(row.last_layer, language));
}

std::string name_in_words(const std::string& name, const Language& language) {
    for (const std::string& context : name_contexts()) {
        std::string found = language.text(context, name);
        if (found != name) return found;
    }
    return name;
}

/// The first "..." of a page, on one line or over two; npos if there is none.
struct Quotes {
    std::size_t open = std::string_view::npos;
    std::size_t close = std::string_view::npos;
};

Quotes next_quotes(std::string_view page, std::size_t from) {
    const std::size_t open = page.find('"', from);
    if (open == std::string_view::npos) return {};
    return {open, page.find('"', open + 1)};
}

/// Leaves out the line's end and the next line's indentation.
std::string name_between(std::string_view page, Quotes quotes) {
    std::string name;
    for (const char c : page.substr(quotes.open + 1, quotes.close - quotes.open - 1)) {
        const bool is_blank = c == ' ' || c == '\n';
        if (!is_blank || !name.ends_with(' ')) name += is_blank ? ' ' : c;
    }
    return name;
}

}  // namespace

std::vector<std::string> name_contexts() {
    return {"operator", "setting", "visit"};
}

std::vector<std::string> quoted_names(std::string_view page) {
    std::vector<std::string> names;
    for (Quotes quotes = next_quotes(page, 0); quotes.close != std::string_view::npos;
         quotes = next_quotes(page, quotes.close + 1))
        names.push_back(name_between(page, quotes));
    return names;
}

std::string allowed_values(const SettingRow& row, const Language& language) {
    if (std::holds_alternative<bool Settings::*>(row.field))
        return said(language, "true ({0}) or false ({1})",
                    {language.text("setting", "on"), language.text("setting", "off")});
    if (std::holds_alternative<std::string Settings::*>(row.field))
        return said(language, allowed_values(row));
    std::string choices;
    for (const std::string_view written : row.choices) {
        const std::string one = choice(written, language.text("setting", std::string(written)));
        choices = choices.empty() ? one : said(language, "{0} or {1}", {choices, one});
    }
    if (!choices.empty()) return choices;
    const bool is_whole = std::holds_alternative<int Settings::*>(row.field);
    return said(language, is_whole ? "a whole number from {0} to {1}" : "a number from {0} to {1}",
                {fmt::format("{:g}", row.range.least), fmt::format("{:g}", row.range.most)});
}

std::string settings_page(const Language& language) {
    std::string page;
    std::string_view table;
    for (const SettingRow& row : setting_rows()) {
        if (row.table != table)
            page += "### " + said(language, "Settings in section {0}", {row.table}) + "\n\n";
        table = row.table;
        page += paragraphs_of(row, language);
    }
    return page;
}

std::string filled_page(std::string_view page, const Language& language) {
    std::string filled;
    std::size_t done = 0;
    for (Quotes quotes = next_quotes(page, 0); quotes.close != std::string_view::npos;
         quotes = next_quotes(page, quotes.close + 1)) {
        filled += page.substr(done, quotes.open - done);
        filled += said(language, "“{0}”", {name_in_words(name_between(page, quotes), language)});
        done = quotes.close + 1;
    }
    filled += page.substr(done);
    const std::size_t line = filled.find(settings_line);
    if (line != std::string::npos)
        filled.replace(line, settings_line.size(), settings_page(language));
    return filled;
}

}  // namespace touchline
