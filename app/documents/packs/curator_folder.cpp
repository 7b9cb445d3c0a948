#include "app/documents/packs/curator_folder.h"

#include "app/documents/decode/files.h"
#include "app/documents/packs/curator_texts.h"
#include "app/documents/packs/plain_names.h"
#include "audio-cues/words/language.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/core.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

std::string told_finding(const PackFinding& finding) {
    return sentence_of(finding, Language());
}

/// What keeps a file of the folder from being read; empty: nothing.
std::string trouble_with_entry(const fs::directory_entry& entry, const std::string& name) {
    std::error_code error;
    const auto type = entry.symlink_status(error).type();
    if (const auto trouble = trouble_with_name(name))
        return told_finding(refused(*trouble, name).value());
    if (type == fs::file_type::directory)
        return curator_fault(name, 0, "this is a folder; lay its files beside it");
    if (type == fs::file_type::symlink) return told_finding({FindingKind::link, name});
    if (type != fs::file_type::regular) return told_finding({FindingKind::no_file, name});
    if (entry.file_size(error) > pack_limits.file_bytes)
        return told_finding(refused(FindingKind::file_too_large, name).value());
    return {};
}

bool is_among(const std::vector<std::string>& languages, const std::string& language) {
    return std::ranges::find(languages, language) != languages.end();
}

/// "The Old Quay" is "the-old-quay".
std::string id_of(const std::string& name) {
    std::string id;
    for (const char c : in_small_letters(name)) {
        const bool fits = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (fits)
            id += c;
        else if (!id.empty() && id.back() != '-')
            id += '-';
    }
    while (id.ends_with('-')) id.pop_back();
    return id.substr(0, 60);
}

std::vector<std::string> words_in(std::string text) {
    std::ranges::replace(text, ',', ' ');
    std::vector<std::string> words;
    for (std::size_t at = text.find_first_not_of(' '); at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        words.push_back(text.substr(at, end - at));
        at = std::min(text.find_first_not_of(' ', end), text.size());
    }
    return words;
}

/// Takes the line if it has this key.
bool take_text(const CuratorLine& line, std::string_view key, std::string& into) {
    if (in_small_letters(line.key) != key) return false;
    into = line.value;
    return true;
}

bool take_title(const CuratorLine& line, PackInfo& info) {
    const std::string key = in_small_letters(line.key);
    if (key != "title" && !key.starts_with("title ")) return false;
    const std::string language = key == "title" ? "" : line.key.substr(6);
    info.title.push_back({language, line.value});
    return language.empty() || is_language_tag(language);
}

/// A title without a language is that of the first one if others have their own. In the order in
/// which pack.toml is read.
void mind_titles(PackInfo& info) {
    if (info.title.size() < 2 || info.languages.empty()) return;
    for (LanguageText& title : info.title)
        if (title.language.empty()) title.language = info.languages.front();
    std::ranges::sort(info.title, {}, &LanguageText::language);
}

void mind_missing(const PackInfo& info, std::vector<std::string>& faults) {
    const auto mind = [&faults](const char* key, bool is_there) {
        if (!is_there)
            faults.push_back(
                curator_fault(curator_table_name, 0, fmt::format("“{}” is missing; add it", key)));
    };
    mind("id", !info.id.empty());
    mind("title", !info.title.empty());
    mind("author", !info.author.empty());
    mind("licence", !info.licence.empty());
    mind("languages", !info.languages.empty());
}

/// No worker is asked for a language that is none.
void mind_languages(PackInfo& info, std::vector<std::string>& faults) {
    bool are_good = true;
    for (const std::string& language : info.languages) {
        if (is_language_tag(language)) continue;
        are_good = false;
        faults.push_back(
            curator_fault(curator_table_name, 0,
                          fmt::format("“{}” is no language; write one like en", language)));
    }
    if (!are_good) info.languages.clear();
}

}  // namespace

FolderFiles read_curator_folder(const std::string& folder, std::vector<std::string>& faults) {
    FolderFiles files;
    std::error_code error;
    fs::directory_iterator it(folder, error);
    for (const fs::directory_iterator end; !error && it != end; it.increment(error)) {
        const std::string name = it->path().filename().string();
        if (is_litter(name) || is_litter(name + '/')) continue;
        std::string trouble = trouble_with_entry(*it, name);
        auto bytes = trouble.empty() ? read_file(it->path().string())
                                     : Result<std::vector<std::byte>>(failure(trouble));
        if (bytes)
            files.emplace(name, std::move(*bytes));
        else
            faults.push_back(trouble.empty() ? told_finding({FindingKind::unreadable, name})
                                             : std::move(trouble));
    }
    if (error) faults.push_back(told_finding({FindingKind::no_such_pack, folder}));
    if (files.size() > pack_limits.files)
        faults.push_back(told_finding(refused(FindingKind::too_many_files).value()));
    std::ranges::sort(faults);  // a folder has no order
    return files;
}

std::string stem_of(const std::string& name) {
    return name.substr(0, name.rfind('.'));
}

bool is_traced(const std::string& name) {
    constexpr std::array endings{".png",  ".jpg",  ".jpeg", ".gif",  ".bmp", ".tif",
                                 ".tiff", ".webp", ".heic", ".heif", ".pdf"};
    const std::string small = in_small_letters(name);
    return std::ranges::any_of(endings,
                               [&small](const char* ending) { return small.ends_with(ending); });
}

bool is_picture(const std::string& name) {
    return kind_by_name(name) == PackFileKind::picture || is_traced(name);
}

BesidePicture beside_picture(const std::string& name, const std::set<std::string>& pictures,
                             const std::vector<std::string>& languages) {
    BesidePicture beside;
    const std::string stem = stem_of(name);
    for (const std::string& picture : pictures)
        if ((stem == picture || stem.starts_with(picture + '.')) &&
            picture.size() > beside.picture.size())
            beside.picture = picture;
    if (beside.picture.empty() || stem == beside.picture) return beside;
    std::string rest = stem.substr(beside.picture.size() + 1);
    const std::string first = rest.substr(0, rest.find('.'));
    if (is_among(languages, first)) {
        beside.language = first;
        rest.erase(0, std::min(first.size() + 1, rest.size()));
    }
    beside.part = rest;
    return beside;
}

PackInfo curator_info(const FolderFiles& files, const std::string& folder,
                      std::vector<std::string>& faults) {
    PackInfo info;
    const auto table = files.find(curator_table_name);
    if (table == files.end()) {
        faults.push_back(
            curator_fault(curator_table_name, 0,
                          "it is missing; write title, author, licence and languages into it"));
        return info;
    }
    CuratorTexts texts = curator_texts(curator_table_name, table->second);
    faults.insert(faults.end(), texts.faults.begin(), texts.faults.end());
    std::string languages;
    std::string version = "1";
    for (const CuratorLine& line : texts.lines) {
        const bool is_known =
            take_text(line, "id", info.id) || take_title(line, info) ||
            take_text(line, "author", info.author) || take_text(line, "licence", info.licence) ||
            take_text(line, "license", info.licence) || take_text(line, "version", version) ||
            take_text(line, "languages", languages);
        if (!is_known)
            faults.push_back(curator_fault(
                curator_table_name, line.line,
                fmt::format("“{}” is not known; write id, title, author, licence, version or "
                            "languages",
                            line.key)));
    }
    info.languages = words_in(languages);
    if (info.id.empty())
        info.id = id_of(fs::absolute(fs::path(folder) / "").parent_path().filename().string());
    mind_titles(info);
    mind_missing(info, faults);
    mind_languages(info, faults);
    if (const auto known = version_of(version))
        info.version = *known;
    else
        faults.push_back(
            curator_fault(curator_table_name, 0, "the version is none; write one like 1.0"));
    return info;
}

}  // namespace touchline
