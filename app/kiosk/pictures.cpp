#include "app/kiosk/pictures.h"

#include "app/decode/map_svg.h"
#include "app/decode/opening.h"
#include "app/gallery/gallery.h"
#include "app/packs/pack_library.h"

#include <algorithm>
#include <filesystem>

namespace touchline {
namespace {

namespace fs = std::filesystem;

/// The worker draws it for the screen. Its words are read here, in the chosen language: the gallery
/// is trusted.
Result<Page> open_in(const std::string& path, const LanguageTag& language, const PageOrder& order) {
    auto page = open_page_of(path, order);
    if (!page) return page;
    auto map = read_map_svg(path, language);
    if (!map) return tl::unexpected(map.error());
    page->told = std::move(*map);
    return page;
}

Result<Page> open_pack_picture(const std::string& path, const LanguageTag& language,
                               const PageOrder& order) {
    auto page = open_page_of(path, order);
    if (!page) return page;
    auto map = read_pack_map(path, language);
    if (!map) return failure(sentence_of(map.error(), Language()));
    page->told = std::move(*map);
    return page;
}

/// Names the picture in an error, and not its place on the disk.
Result<Page> told_by_title(Result<Page> page, const std::string& path, const std::string& title) {
    if (!page && page.error().line.starts_with(path))
        return failure(title + page.error().line.substr(path.size()));
    return page;
}

FilePtr gallery_file(const GalleryEntry& entry, const LanguageTag& language) {
    const std::string path = entry.path;
    return std::make_shared<const PictureFile>(
        PictureFile{entry.title, entry.title, fs::path(path).filename().string(), false,
                    [path, title = entry.title, language](const PageOrder& order) {
                        return told_by_title(open_in(path, language, order), path, title);
                    }});
}

/// This process parses nothing of a pack.
FilePtr pack_file(const GalleryEntry& entry, const LanguageTag& language) {
    const std::string path = entry.path;
    return std::make_shared<const PictureFile>(
        PictureFile{entry.title, entry.title, "", false,
                    [path, title = entry.title, language](const PageOrder& order) {
                        return told_by_title(open_pack_picture(path, language, order), path, title);
                    }});
}

/// The file whose name ends like this after its number.
FilePtr named(const std::vector<FilePtr>& files, std::string_view ending) {
    const auto at = std::ranges::find_if(
        files, [ending](const FilePtr& file) { return file->gallery_file.ends_with(ending); });
    return at == files.end() ? nullptr : *at;
}

/// The same picture in the list of this language, with its words; the file itself if there is none.
FilePtr in_language(const FilePtr& file, const std::vector<std::vector<FilePtr>>& lists,
                    std::size_t language) {
    if (!file || file->gallery_file.empty() || language >= lists.size()) return file;
    const FilePtr same = named(lists[language], file->gallery_file);
    return same ? same : file;
}

FilePtr at(const std::vector<FilePtr>& files, std::size_t index) {
    return index < files.size() ? files[index] : nullptr;
}

}  // namespace

Result<Gallery> read_gallery(const std::string& folder, const std::string& library,
                             const std::vector<Language>& languages) {
    Gallery gallery;
    for (const Language& language : languages) {
        const LanguageTag tag{language.code()};
        const auto entries = list_gallery(folder, tag);
        if (!entries) return tl::unexpected(entries.error());
        std::vector<GalleryTitle>& titles = gallery.titles.emplace_back();
        std::vector<FilePtr>& files = gallery.files.emplace_back();
        for (const GalleryEntry& entry : *entries) {
            titles.push_back({entry.title, entry.description, entry.difficulty});
            files.push_back(gallery_file(entry, tag));
        }
        if (library.empty()) continue;
        std::vector<PackFinding> problems;  // the pack's importer was told
        for (const LibraryPicture& picture : list_library(library, tag, problems)) {
            const GalleryEntry& entry = picture.entry;
            titles.push_back({entry.title, entry.description, entry.difficulty});
            files.push_back(pack_file(entry, tag));
        }
    }
    gallery.circle = named(gallery.files.front(), "-circle.svg");
    gallery.square = named(gallery.files.front(), "-square.svg");
    return gallery;
}

FilePtr Pictures::of(const LoadPicture& order) const {
    switch (order.source) {
        case PictureSource::practice:
            return in_language(order.index == 0 ? gallery_.circle : gallery_.square, gallery_.files,
                               order.language);
        case PictureSource::gallery:
            return order.language < gallery_.files.size()
                       ? at(gallery_.files[order.language], order.index)
                       : nullptr;
        case PictureSource::stick:
            return at(stick_, order.index);
        case PictureSource::camera:
            return photo_;
    }
    return nullptr;
}

void Pictures::forget() {
    stick_.clear();
    photo_.reset();
}

}  // namespace touchline
