#include "app/documents/packs/pack_library.h"

#include "app/documents/decode/files.h"
#include "app/documents/decode/one_line.h"
#include "app/documents/packs/plain_names.h"
#include "app/documents/packs/unpacking.h"
#include "app/isolation/process/places.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

tl::unexpected<PackFinding> unwritable(const fs::path& library) {
    return refusal({FindingKind::library_unwritable, library.string()});
}

/// Begins with a dot, so that no list takes it for a pack.
constexpr const char* unfinished = ".unfinished-";

void remove_leftovers(const fs::path& library) {
    std::error_code error;
    std::vector<fs::path> leftovers;
    for (fs::directory_iterator it(library, error), end; !error && it != end; it.increment(error))
        if (it->path().filename().string().starts_with(unfinished)) leftovers.push_back(it->path());
    for (const fs::path& leftover : leftovers) fs::remove_all(leftover, error);
}

bool write_files(const Pack& pack, const fs::path& folder) {
    for (const PackFile& file : pack.files) {
        const fs::path path = folder / file.name;
        std::error_code error;
        fs::create_directories(path.parent_path(), error);
        if (error || !write_whole_file(path.string(), file.bytes)) return false;
    }
    flush_folder(folder);
    return true;
}

/// Swaps both in one step, so that the library holds the old pack or the new one. The old one is
/// then at `made`.
bool put_in_place(const fs::path& made, const fs::path& place) {
    if (::renameat2(AT_FDCWD, made.c_str(), AT_FDCWD, place.c_str(), RENAME_EXCHANGE) == 0)
        return true;
    return errno == ENOENT && ::rename(made.c_str(), place.c_str()) == 0;
}

PackResult<PackInfo> info_of(const fs::path& folder) {
    const auto bytes = read_file((folder / pack_table_name).string());
    if (!bytes) return refusal({FindingKind::no_pack_toml, folder.filename().string()});
    auto info = pack_info_of(as_text(*bytes));
    if (!info) {
        PackFinding finding = info.error();
        finding.file = folder.filename().string() + '/' + finding.file;
        return refusal(std::move(finding));
    }
    return info;
}

PackResult<std::string> install(const Pack& pack, const fs::path& library) {
    std::error_code error;
    fs::create_directories(library, error);
    if (error) return unwritable(library);
    remove_leftovers(library);
    const fs::path made = library / (unfinished + pack.info.id + '-' + std::to_string(::getpid()));
    const fs::path place = library / pack.info.id;
    const bool is_done = write_files(pack, made) && put_in_place(made, place);
    fs::remove_all(made, error);  // the old pack, or one that could not be finished
    if (!is_done) return unwritable(library);
    flush_folder(library);
    return place.string();
}

std::vector<fs::path> packs_in(const fs::path& library) {
    std::vector<fs::path> folders;
    std::error_code error;
    for (fs::directory_iterator it(library, error), end; !error && it != end; it.increment(error)) {
        const bool is_pack = it->symlink_status(error).type() == fs::file_type::directory &&
                             !it->path().filename().string().starts_with('.');
        if (is_pack) folders.push_back(it->path());
    }
    std::ranges::sort(folders);
    return folders;
}

PackResult<PackFile> file_at(const fs::path& path) {
    auto bytes = read_file(path.string());
    if (!bytes) return refusal({FindingKind::unreadable, path.filename().string()});
    return PackFile{path.filename().string(), std::move(*bytes)};
}

std::string tag_of(const LanguageTag& language) {
    return is_language_tag(language.text) ? language.text : LanguageTag{}.text;
}

PackResult<PackPictureLook> look_at(const fs::path& path, const LanguageTag& language) {
    return file_at(path).and_then(
        [&](const PackFile& file) { return open_picture(file, {tag_of(language)}); });
}

void list_pack(const fs::path& folder, const LanguageTag& language,
               std::vector<LibraryPicture>& pictures, std::vector<PackFinding>& problems) {
    const auto info = info_of(folder);
    if (!info) {
        problems.push_back(info.error());
        return;
    }
    for (const PackPicture& picture : info->pictures) {
        const fs::path path = folder / picture.file;
        auto look = look_at(path, language);
        if (!look) {
            problems.push_back(look.error());
            continue;
        }
        pictures.push_back(
            {info->id,
             title_in(*info, language.text),
             {path.string(), std::move(look->map.title), std::move(look->map.description),
              picture.difficulty ? picture.difficulty : look->difficulty}});
    }
}

/// Empty if the picture has no such part.
std::string text_said(const PackSound& sound, const TactileMap& map) {
    switch (sound.says) {
        case SoundText::title:
            return map.title;
        case SoundText::description:
            return map.description;
        case SoundText::part:
            for (const Outline& outline : map.outlines)
                if (outline.id == sound.part) return outline.label;
            return {};
    }
    return {};
}

/// The pack's folder: the path without the picture's own folders.
fs::path folder_of(const LibraryPicture& picture) {
    for (fs::path at = fs::path(picture.entry.path).parent_path(); at.has_relative_path();
         at = at.parent_path())
        if (at.filename() == picture.pack) return at;
    return {};
}

}  // namespace

PackResult<std::string> import_pack(const Pack& pack, const std::string& library, OlderPack older) {
    try {
        if (const auto findings = check_pack(pack); !can_be_used(findings))
            return refusal(findings.front());
        const auto installed = info_of(fs::path(library) / pack.info.id);
        if (installed && pack.info.version < installed->version && older == OlderPack::ask)
            return refusal({FindingKind::older, pack.info.id, 0, text_of(installed->version)});
        return install(pack, library);
    } catch (const std::exception&) {
        return unwritable(library);
    }
}

std::vector<LibraryPicture> list_library(const std::string& library, const LanguageTag& language,
                                         std::vector<PackFinding>& problems) {
    std::vector<LibraryPicture> pictures;
    try {
        for (const fs::path& folder : packs_in(library))
            list_pack(folder, language, pictures, problems);
    } catch (const std::exception&) {
        problems.push_back({FindingKind::unreadable, library});
    }
    return pictures;
}

PackResult<TactileMap> read_pack_map(const std::string& path, const LanguageTag& language) {
    return look_at(path, language).map([](PackPictureLook look) { return std::move(look.map); });
}

std::vector<RecordedText> recorded_texts(const LibraryPicture& picture, const LanguageTag& language,
                                         std::vector<PackFinding>& problems) {
    std::vector<RecordedText> recorded;
    const fs::path folder = folder_of(picture);
    const auto info = info_of(folder);
    const auto map = read_pack_map(picture.entry.path, language);
    if (!info || !map) {
        problems.push_back(info ? map.error() : info.error());
        return recorded;
    }
    for (const PackSound& sound : info->sounds) {
        const bool is_meant =
            folder / sound.picture == fs::path(picture.entry.path) &&
            in_small_letters(sound.language) == in_small_letters(tag_of(language));
        std::string text = is_meant ? text_said(sound, *map) : std::string{};
        if (text.empty()) continue;
        const auto file = file_at(folder / sound.file);
        auto look = file ? open_sound(*file) : PackResult<PackSoundLook>(refusal(file.error()));
        if (look)
            recorded.push_back({language.text, std::move(text), std::move(look->samples)});
        else
            problems.push_back(look.error());
    }
    return recorded;
}

std::string library_folder() {
    if (const std::string chosen = environment("TOUCHLINE_LIBRARY"); !chosen.empty()) return chosen;
    return (user_data_folder() / "touchline" / "packs").string();
}

}  // namespace touchline
