#include "app/documents/decode/one_line.h"
#include "app/documents/packs/pack.h"
#include "app/documents/packs/plain_names.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <exception>
#include <initializer_list>
#include <set>
#include <sstream>
#include <utility>

#include <toml++/toml.h>

namespace touchline {
namespace {

/// What is wrong, for pack_info_of(), to which toml++ throws as well.
struct WrongToml : std::exception {
    explicit WrongToml(PackFinding what_is_wrong) : finding(std::move(what_is_wrong)) {}

    PackFinding finding;
};

[[noreturn]] void refuse(FindingKind kind, const toml::node& node, std::string_view what,
                         double value = 0.0) {
    throw WrongToml({kind, pack_table_name, static_cast<int>(node.source().begin.line),
                     std::string(what), value});
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_letter_or_digit(char c) {
    return is_letter(c) || (c >= '0' && c <= '9');
}

/// True for one line that can be shown and said.
bool is_text(const std::string& text) {
    return !text.empty() && is_utf8(text) && one_spaced(text, pack_limits.text_bytes) == text;
}

bool is_id(std::string_view id) {
    const auto fits = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
    };
    return !id.empty() && id.size() <= 60 && std::ranges::all_of(id, fits) && id.front() != '-' &&
           id.back() != '-';
}

void check_keys(const toml::table& table, std::initializer_list<std::string_view> known) {
    for (const auto& [key, node] : table)
        if (std::ranges::find(known, key.str()) == known.end())
            refuse(FindingKind::toml_unknown, node, key.str());
}

const toml::node& required(const toml::table& table, std::string_view key) {
    const toml::node* const node = table.get(key);
    if (node == nullptr) refuse(FindingKind::toml_missing, table, key);
    return *node;
}

/// A required key, as a text that `fits`.
template <class Fits>
std::string text_at(const toml::table& table, std::string_view key, Fits fits) {
    const toml::node& node = required(table, key);
    const auto* text = node.as_string();
    if (text == nullptr || !fits(text->get())) refuse(FindingKind::toml_value, node, key);
    return text->get();
}

bool is_plain_name(const std::string& name) {
    return !trouble_with_name(name);
}

/// One text for all languages, or a table with one per language.
std::vector<LanguageText> titles_in(const toml::table& table) {
    const toml::node& node = required(table, "title");
    std::vector<LanguageText> titles;
    if (const auto* text = node.as_string()) titles.push_back({"", text->get()});
    if (const auto* texts = node.as_table()) {
        for (const auto& [language, text] : *texts) {
            if (!is_language_tag(language.str()) || !text.is_string())
                refuse(FindingKind::toml_value, text, "title");
            titles.push_back({std::string(language.str()), text.as_string()->get()});
        }
    }
    const bool are_good =
        std::ranges::all_of(titles, [](const LanguageText& title) { return is_text(title.text); });
    if (titles.empty() || titles.size() > pack_limits.languages || !are_good)
        refuse(FindingKind::toml_value, node, "title");
    return titles;
}

std::vector<std::string> languages_in(const toml::table& table) {
    const toml::node& node = required(table, "languages");
    const auto* tags = node.as_array();
    if (tags == nullptr || tags->empty() || tags->size() > pack_limits.languages)
        refuse(FindingKind::toml_value, node, "languages");
    std::vector<std::string> languages;
    std::set<std::string> seen;
    for (const toml::node& tag : *tags) {
        const auto* text = tag.as_string();
        if (text == nullptr || !is_language_tag(text->get()) ||
            !seen.insert(in_small_letters(text->get())).second)
            refuse(FindingKind::toml_value, tag, "languages");
        languages.push_back(text->get());
    }
    return languages;
}

std::string file_in(const toml::table& table, PackFileKind kind) {
    return text_at(table, "file", [kind](const std::string& name) {
        return is_plain_name(name) && kind_by_name(name) == kind;
    });
}

PackPicture picture_in(const toml::table& table) {
    check_keys(table, {"file", "difficulty"});
    PackPicture picture{file_in(table, PackFileKind::picture), std::nullopt};
    if (const toml::node* node = table.get("difficulty")) {
        const auto* grade = node->as_integer();
        if (grade == nullptr || grade->get() < 1 || grade->get() > 5)
            refuse(FindingKind::toml_value, *node, "difficulty");
        picture.difficulty = static_cast<int>(grade->get());
    }
    return picture;
}

PackSound sound_in(const toml::table& table) {
    check_keys(table, {"file", "picture", "language", "says", "part"});
    PackSound sound;
    sound.file = file_in(table, PackFileKind::sound);
    sound.picture = text_at(table, "picture", is_plain_name);
    sound.language = text_at(table, "language", is_language_tag);
    if (table.contains("part")) {
        sound.says = SoundText::part;
        sound.part = text_at(table, "part", is_text);
        if (table.contains("says")) refuse(FindingKind::toml_unknown, table, "says");
        return sound;
    }
    const std::string says = text_at(table, "says", [](const std::string& text) {
        return text == "title" || text == "description";
    });
    sound.says = says == "title" ? SoundText::title : SoundText::description;
    return sound;
}

/// What the tables of [[key]] hold.
template <class Item>
std::vector<Item> items_in(const toml::table& table, std::string_view key, std::size_t most,
                           Item (*item_in)(const toml::table&)) {
    std::vector<Item> items;
    const toml::node* node = table.get(key);
    if (node == nullptr) return items;
    const auto* tables = node->as_array();
    if (tables == nullptr || tables->empty()) refuse(FindingKind::toml_value, *node, key);
    if (tables->size() > most)
        refuse(FindingKind::too_many_named, *node, key, static_cast<double>(most));
    for (const toml::node& element : *tables) {
        if (!element.is_table()) refuse(FindingKind::toml_value, element, key);
        items.push_back(item_in(*element.as_table()));
    }
    return items;
}

/// Refuses a picture listed twice, a text recorded twice, and a sound of a picture that is not
/// listed.
void check_whole(const PackInfo& info) {
    const auto refuse_table = [](FindingKind kind, const std::string& what) {
        throw WrongToml({kind, pack_table_name, 0, what});
    };
    std::set<std::string> pictures;
    for (const PackPicture& picture : info.pictures)
        if (!pictures.insert(picture.file).second)
            refuse_table(FindingKind::toml_value, picture.file);
    std::set<std::tuple<std::string, std::string, SoundText, std::string>> said;
    for (const PackSound& sound : info.sounds) {
        if (!pictures.contains(sound.picture))
            refuse_table(FindingKind::not_in_pack, sound.picture);
        if (!said.insert({sound.picture, sound.language, sound.says, sound.part}).second)
            refuse_table(FindingKind::toml_value, sound.file);
    }
}

PackInfo info_in(const toml::table& table) {
    check_keys(table,
               {"id", "title", "author", "licence", "version", "languages", "picture", "sound"});
    PackInfo info;
    info.id = text_at(table, "id", is_id);
    info.title = titles_in(table);
    info.author = text_at(table, "author", is_text);
    info.licence = text_at(table, "licence", is_text);
    info.version = *version_of(text_at(
        table, "version", [](const std::string& text) { return version_of(text).has_value(); }));
    info.languages = languages_in(table);
    info.pictures = items_in(table, "picture", pack_limits.pictures, picture_in);
    if (info.pictures.empty()) refuse(FindingKind::toml_missing, table, "[[picture]]");
    info.sounds = items_in(table, "sound", pack_limits.sounds, sound_in);
    check_whole(info);
    return info;
}

std::string quoted(const std::string& text) {
    std::ostringstream made;
    made << toml::value(text);
    return made.str();
}

std::string titles_as_toml(const std::vector<LanguageText>& titles) {
    if (titles.size() == 1 && titles.front().language.empty()) return quoted(titles.front().text);
    std::string made;
    for (const LanguageText& title : titles)
        made += (made.empty() ? "{ " : ", ") + title.language + " = " + quoted(title.text);
    return made + " }";
}

std::string sound_as_toml(const PackSound& sound) {
    std::string made = "\n[[sound]]\nfile = " + quoted(sound.file) +
                       "\npicture = " + quoted(sound.picture) +
                       "\nlanguage = " + quoted(sound.language) + '\n';
    switch (sound.says) {
        case SoundText::title:
            return made + "says = \"title\"\n";
        case SoundText::description:
            return made + "says = \"description\"\n";
        case SoundText::part:
            return made + "part = " + quoted(sound.part) + '\n';
    }
    return made;
}

}  // namespace

std::optional<PackVersion> version_of(std::string_view text) {
    PackVersion version;
    int* const places[]{&version.major, &version.minor, &version.patch};
    for (int* place : places) {
        const auto dot = std::min(text.find('.'), text.size());
        const auto number = number_in(text.substr(0, dot), 0, 9999);
        if (!number) return std::nullopt;
        *place = *number;
        if (dot == text.size()) return version;
        text.remove_prefix(dot + 1);
    }
    return std::nullopt;
}

bool is_language_tag(std::string_view tag) {
    if (tag.size() > 35) return false;
    const auto hyphen = std::min(tag.find('-'), tag.size());
    const std::string_view first = tag.substr(0, hyphen);
    if (first.size() < 2 || first.size() > 3 || !std::ranges::all_of(first, is_letter))
        return false;
    for (std::size_t at = hyphen; at < tag.size();) {
        const std::size_t end = std::min(tag.find('-', at + 1), tag.size());
        const std::string_view part = tag.substr(at + 1, end - at - 1);
        if (part.empty() || part.size() > 8 || !std::ranges::all_of(part, is_letter_or_digit))
            return false;
        at = end;
    }
    return true;
}

PackResult<PackInfo> pack_info_of(std::string_view toml) {
    if (toml.size() > pack_limits.toml_bytes) {
        constexpr double megabyte = 1 << 20U;
        return refusal({FindingKind::file_too_large, pack_table_name, 0, "",
                        static_cast<double>(pack_limits.toml_bytes) / megabyte});
    }
    try {
        return info_in(toml::parse(toml));
    } catch (const WrongToml& wrong) {
        return refusal(wrong.finding);
    } catch (const toml::parse_error& problem) {
        return refusal({FindingKind::toml_syntax, pack_table_name,
                        static_cast<int>(problem.source().begin.line)});
    } catch (const std::exception&) {
        return refusal({FindingKind::toml_syntax, pack_table_name});
    }
}

std::string toml_of(const PackInfo& info) {
    std::string languages;
    for (const std::string& language : info.languages)
        languages += (languages.empty() ? "" : ", ") + quoted(language);
    std::string made = "id = " + quoted(info.id) + "\ntitle = " + titles_as_toml(info.title) +
                       "\nauthor = " + quoted(info.author) + "\nlicence = " + quoted(info.licence) +
                       "\nversion = " + quoted(text_of(info.version)) + "\nlanguages = [" +
                       languages + "]\n";
    for (const PackPicture& picture : info.pictures) {
        made += "\n[[picture]]\nfile = " + quoted(picture.file) + '\n';
        if (picture.difficulty)
            made += "difficulty = " + std::to_string(*picture.difficulty) + '\n';
    }
    for (const PackSound& sound : info.sounds) made += sound_as_toml(sound);
    return made;
}

std::string text_of(const PackVersion& version) {
    return std::to_string(version.major) + '.' + std::to_string(version.minor) + '.' +
           std::to_string(version.patch);
}

const std::string& title_in(const PackInfo& info, const std::string& language) {
    for (const std::string& wanted : {in_small_letters(language), std::string()})
        for (const LanguageText& title : info.title)
            if (in_small_letters(title.language) == wanted) return title.text;
    return info.title.front().text;
}

}  // namespace touchline
