#include "app/documents/packs/pack.h"

#include "app/documents/decode/files.h"
#include "app/documents/decode/one_line.h"
#include "app/documents/packs/plain_names.h"
#include "app/documents/packs/unpacking.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>

namespace touchline {
namespace {

namespace fs = std::filesystem;

/// Walks a folder for names that may be read. Refuses links and does not follow them.
PackResult<std::vector<std::string>> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    std::set<std::string> seen;
    std::error_code error;
    fs::recursive_directory_iterator it(folder, error);
    for (const fs::recursive_directory_iterator end; !error && it != end; it.increment(error)) {
        const std::string name = it->path().lexically_relative(folder).generic_string();
        if (is_litter(name) || is_litter(name + '/')) {
            it.disable_recursion_pending();
            continue;
        }
        const auto type = it->symlink_status(error).type();
        if (error) break;
        if (type == fs::file_type::symlink) return refused(FindingKind::link, name);
        if (const auto trouble = trouble_with_name(name)) return refused(*trouble, name);
        if (type == fs::file_type::directory) continue;
        if (type != fs::file_type::regular) return refused(FindingKind::no_file, name);
        if (!seen.insert(in_small_letters(name)).second) return refused(FindingKind::twice, name);
        names.push_back(name);
        if (names.size() > pack_limits.files) return refused(FindingKind::too_many_files);
    }
    if (error) return refused(FindingKind::unreadable);
    std::ranges::sort(names);
    return names;
}

PackResult<std::vector<PackFile>> files_in(const fs::path& folder) {
    const auto names = names_in(folder);
    if (!names) return refusal(names.error());
    std::vector<PackFile> files;
    std::size_t all = 0;
    for (const std::string& name : *names) {
        std::error_code error;
        const auto size = fs::file_size(folder / name, error);
        if (error) return refused(FindingKind::unreadable, name);
        if (size > pack_limits.file_bytes) return refused(FindingKind::file_too_large, name);
        auto bytes = read_file(folder / name);
        if (!bytes) return refused(FindingKind::unreadable, name);
        all += bytes->size();
        if (all > pack_limits.all_bytes) return refused(FindingKind::all_too_large);
        files.push_back({name, std::move(*bytes)});
    }
    return files;
}

/// A person who packs a folder rather than its contents puts its name before every file.
void take_out_of_single_folder(std::vector<PackFile>& files) {
    if (files.empty()) return;
    const std::string folder = files.front().name.substr(0, files.front().name.find('/') + 1);
    const bool is_around_all =
        !folder.empty() && std::ranges::all_of(files, [&](const PackFile& file) {
            return file.name.starts_with(folder);
        });
    if (!is_around_all) return;
    for (PackFile& file : files) file.name.erase(0, folder.size());
}

PackResult<Pack> pack_of(std::vector<PackFile> files) {
    take_out_of_single_folder(files);
    Pack pack{{}, std::move(files)};
    const PackFile* table = find_file(pack, pack_table_name);
    if (table == nullptr) return refused(FindingKind::no_pack_toml);
    auto info = pack_info_of(as_text(table->bytes));
    if (!info) return refusal(info.error());
    pack.info = std::move(*info);
    std::vector<std::string> named;
    for (const PackPicture& picture : pack.info.pictures) named.push_back(picture.file);
    for (const PackSound& sound : pack.info.sounds) named.push_back(sound.file);
    for (const std::string& name : named)
        if (find_file(pack, name) == nullptr)
            return refusal({FindingKind::not_in_pack, pack_table_name, 0, name});
    return pack;
}

PackResult<Pack> read(const std::string& path) {
    std::error_code error;
    const auto status = fs::status(path, error);
    if (!fs::exists(status)) return refused(FindingKind::no_such_pack, path);
    if (fs::is_directory(status)) return files_in(path).and_then(pack_of);
    const auto size = fs::file_size(path, error);
    if (error || !fs::is_regular_file(status)) return refused(FindingKind::unreadable, path);
    if (size > pack_limits.zip_bytes) return refused(FindingKind::zip_too_large, path);
    const auto bytes = read_file(path);
    if (!bytes) return refused(FindingKind::unreadable, path);
    return read_pack(*bytes);
}

PackResult<void> turn_into_image_layers(Pack& pack, const std::string& language) {
    for (PackFile& file : pack.files) {
        if (kind_by_name(file.name) != PackFileKind::picture) continue;
        auto made = as_image_layers(file, language);
        if (!made) return refusal(made.error());
        file = std::move(*made);
    }
    return {};
}

using PartsOfPictures = std::map<std::string, std::set<std::string>>;

void look_at_pictures(const Pack& pack, PartsOfPictures& parts,
                      std::vector<PackFinding>& findings) {
    for (const PackPicture& picture : pack.info.pictures) {
        const auto look = open_picture(*find_file(pack, picture.file), pack.info.languages);
        if (!look) {
            findings.push_back(look.error());
            continue;
        }
        findings.insert(findings.end(), look->findings.begin(), look->findings.end());
        if (!picture.difficulty && !look->difficulty)  // a grade in pack.toml counts first
            findings.push_back({FindingKind::no_difficulty, picture.file});
        for (const Outline& outline : look->map.outlines) parts[picture.file].insert(outline.id);
    }
}

void look_at_sounds(const Pack& pack, const PartsOfPictures& parts,
                    std::vector<PackFinding>& findings) {
    std::set<std::string> heard;
    for (const PackSound& sound : pack.info.sounds) {
        const auto found = parts.find(sound.picture);
        if (sound.says == SoundText::part && found != parts.end() &&
            !found->second.contains(sound.part))
            findings.push_back({FindingKind::no_such_part, sound.picture, 0, sound.part});
        if (!heard.insert(sound.file).second) continue;
        const auto look = open_sound(*find_file(pack, sound.file));
        if (look)
            findings.insert(findings.end(), look->findings.begin(), look->findings.end());
        else
            findings.push_back(look.error());
    }
}

void look_at_rest(const Pack& pack, std::vector<PackFinding>& findings) {
    std::set<std::string> named{pack_table_name};
    for (const PackPicture& picture : pack.info.pictures) named.insert(picture.file);
    for (const PackSound& sound : pack.info.sounds) named.insert(sound.file);
    for (const PackFile& file : pack.files) {
        if (const auto trouble = trouble_with_file(file.name, file.bytes))
            findings.push_back({*trouble, file.name});
        else if (!named.contains(file.name) && kind_by_name(file.name) != PackFileKind::text)
            findings.push_back({FindingKind::not_named, file.name});
    }
}

}  // namespace

PackResult<Pack> read_pack(std::span<const std::byte> zip) {
    return unpack_zip(zip).and_then(pack_of);
}

PackResult<Pack> read_pack(const std::string& path) {
    try {
        auto pack = read(path);
        if (!pack && pack.error().file.empty())
            pack.error().file = fs::path(path).filename().string();
        return pack;
    } catch (const std::exception&) {
        return refused(FindingKind::unreadable, path);
    }
}

const PackFile* find_file(const Pack& pack, const std::string& name) {
    const auto found = std::ranges::lower_bound(pack.files, name, {}, &PackFile::name);
    return found != pack.files.end() && found->name == name ? &*found : nullptr;
}

PackResult<void> export_pack(const std::string& folder, const std::string& zip_file,
                             const std::string& image_language) {
    auto pack = read_pack(folder);
    if (!pack) return refusal(pack.error());
    if (!image_language.empty())
        if (auto layered = turn_into_image_layers(*pack, image_language); !layered) return layered;
    const auto zip = zip_of(*pack);
    if (!zip) return refusal(zip.error());
    if (!write_whole_file(zip_file, *zip)) return refused(FindingKind::output_unwritable, zip_file);
    return {};
}

std::vector<PackFinding> check_pack(const Pack& pack) {
    std::vector<PackFinding> findings;
    PartsOfPictures parts;
    look_at_pictures(pack, parts, findings);
    look_at_sounds(pack, parts, findings);
    look_at_rest(pack, findings);
    std::ranges::stable_sort(findings, [](const PackFinding& a, const PackFinding& b) {
        return severity_of(a.kind) < severity_of(b.kind);
    });
    return findings;
}

std::vector<PackFinding> check_pack(const std::string& path) {
    const auto pack = read_pack(path);
    return pack ? check_pack(*pack) : std::vector<PackFinding>{pack.error()};
}

bool can_be_used(const std::vector<PackFinding>& findings) {
    return std::ranges::none_of(findings, [](const PackFinding& finding) {
        return severity_of(finding.kind) == FindingSeverity::refusal;
    });
}

}  // namespace touchline
