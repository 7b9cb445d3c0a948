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

/// How well a recording in `has` serves a listener of `wanted`: 2 is best, 0 not at all.
int fit(const std::string& has, const std::string& wanted) {
    const std::string small = in_small_letters(has);
    const std::string sought = in_small_letters(wanted);
    if (small == sought) return 2;
    return small.substr(0, small.find('-')) == sought.substr(0, sought.find('-')) ? 1 : 0;
}

/// The recording of a text of a picture that serves the language best; null: there is none.
const PackSound* sound_of(const PackInfo& info, const PackSound& text) {
    const PackSound* best = nullptr;
    for (const PackSound& sound : info.sounds) {
        const bool is_of_text = sound.picture == text.picture && sound.says == text.says &&
                                sound.part == text.part && fit(sound.language, text.language) > 0;
        if (is_of_text && (best == nullptr ||
                           fit(sound.language, text.language) > fit(best->language, text.language)))
            best = &sound;
    }
    return best;
}

/// Reads recordings until they are as long as one may keep.
struct RecordingReader {
    const fs::path& folder;  // of the pack
    double rest_s;
    std::vector<PackFinding>& problems;

    /// Null if there is none, it cannot be read, or it is too long.
    VoiceRecordingPtr read(const PackSound* sound, double most_s = pack_limits.sound_s) {
        if (sound == nullptr || rest_s <= 0.0) return nullptr;
        auto look = file_at(folder / sound->file).and_then(open_sound);
        if (!look) {
            problems.push_back(look.error());
            return nullptr;
        }
        const double long_s = length_s(look->recording);
        if (long_s > std::min(rest_s, most_s)) return nullptr;
        rest_s -= long_s;
        return std::make_shared<const VoiceRecording>(std::move(look->recording));
    }
};

void list_pack(const fs::path& folder, const LanguageTag& language, double& rest_s,
               std::vector<LibraryPicture>& pictures, std::vector<PackFinding>& problems) {
    const auto info = installed_info(folder);
    if (!info) {
        problems.push_back(info.error());
        return;
    }
    RecordingReader reader{folder, rest_s, problems};
    for (const PackPicture& picture : info->pictures) {
        const fs::path path = folder / picture.file;
        auto look = look_at(path, language);
        if (!look) {
            problems.push_back(look.error());
            continue;
        }
        const PackSound title{{}, picture.file, tag_of(language), SoundText::title, {}};
        const PackSound* const sound = look->map.title.empty() ? nullptr : sound_of(*info, title);
        pictures.push_back(
            {info->id,
             {path.string(), std::move(look->map.title), std::move(look->map.description),
              picture.difficulty ? picture.difficulty : look->difficulty},
             reader.read(sound, longest_name_s)});
    }
    rest_s = reader.rest_s;
}

/// Empty if the picture has no such part.
std::string label_of(const std::string& id, const TactileMap& map) {
    const auto part = std::ranges::find(map.outlines, id, &Outline::id);
    return part == map.outlines.end() ? std::string() : part->label;
}

/// The parts of the picture that are recorded in any language, each once.
std::vector<std::string> recorded_parts(const PackInfo& info, const std::string& picture) {
    std::vector<std::string> parts;
    for (const PackSound& sound : info.sounds)
        if (sound.picture == picture && sound.says == SoundText::part &&
            std::ranges::find(parts, sound.part) == parts.end())
            parts.push_back(sound.part);
    return parts;
}

/// The pack's folder: the path without the picture's own folders.
fs::path folder_of(const LibraryPicture& picture) {
    for (fs::path at = fs::path(picture.entry.path).parent_path(); at.has_relative_path();
         at = at.parent_path())
        if (at.filename() == picture.pack) return at;
    return {};
}

}  // namespace

std::vector<fs::path> installed_packs(const fs::path& library) {
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

PackResult<PackInfo> installed_info(const fs::path& folder) {
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

PackResult<std::string> import_pack(const Pack& pack, const std::string& library, OlderPack older) {
    try {
        if (const auto findings = check_pack(pack); !can_be_used(findings))
            return refusal(findings.front());
        const auto installed = installed_info(fs::path(library) / pack.info.id);
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
        double rest_s = list_recorded_s;
        for (const fs::path& folder : installed_packs(library))
            list_pack(folder, language, rest_s, pictures, problems);
    } catch (const std::exception&) {
        problems.push_back({FindingKind::unreadable, library});
    }
    return pictures;
}

PackResult<TactileMap> read_pack_map(const std::string& path, const LanguageTag& language) {
    return look_at(path, language).map([](PackPictureLook look) { return std::move(look.map); });
}

PictureRecordingsPtr recordings_of(const LibraryPicture& picture, const TactileMap& told,
                                   const LanguageTag& language,
                                   std::vector<PackFinding>& problems) {
    const fs::path folder = folder_of(picture);
    const auto info = installed_info(folder);
    if (!info) {
        problems.push_back(info.error());
        return nullptr;
    }
    const std::string file =
        fs::path(picture.entry.path).lexically_relative(folder).generic_string();
    RecordingReader reader{folder, picture_recorded_s, problems};
    const auto read = [&](SoundText says, const std::string& part, const std::string& text) {
        if (text.empty()) return VoiceRecordingPtr();
        return reader.read(sound_of(*info, {{}, file, tag_of(language), says, part}));
    };
    PictureRecordings found;
    found.title = read(SoundText::title, {}, told.title);
    found.description = read(SoundText::description, {}, told.description);
    for (const std::string& part : recorded_parts(*info, file)) {
        const std::string label = label_of(part, told);
        if (VoiceRecordingPtr recording = read(SoundText::part, part, label))
            found.parts.emplace_back(label, std::move(recording));
    }
    if (!found.title && !found.description && found.parts.empty()) return nullptr;
    return std::make_shared<const PictureRecordings>(std::move(found));
}

std::string library_folder() {
    if (const std::string chosen = environment("TOUCHLINE_LIBRARY"); !chosen.empty()) return chosen;
    return (user_data_folder() / "touchline" / "packs").string();
}

}  // namespace touchline
