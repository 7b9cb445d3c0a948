#include "app/kiosk/pictures.h"

#include "app/documents/decode/map_svg.h"
#include "app/documents/decode/opening.h"
#include "app/documents/gallery/gallery.h"
#include "app/documents/packs/pack_library.h"
#include "app/visit/told_lines.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <utility>

namespace touchline {
namespace {

namespace fs = std::filesystem;

using MapReader = Result<TactileMap> (*)(const std::string& path, const LanguageTag& language);

/// This process parses nothing of a pack.
Result<TactileMap> read_map_of_pack(const std::string& path, const LanguageTag& language) {
    return read_pack_map(path, language).map_error([](const PackFinding& finding) {
        return Error{sentence_of(finding, Language())};
    });
}

/// The worker draws it for the screen; `read` reads its words in the chosen language.
Result<Page> open_in(const std::string& path, const LanguageTag& language, const PageOrder& order,
                     MapReader read) {
    auto page = open_page_of(path, order);
    if (!page) return page;
    auto map = read(path, language);
    if (!map) return tl::unexpected(map.error());
    page->told = std::move(*map);
    return page;
}

using ReadRecordings = std::function<PictureRecordingsPtr(const TactileMap& told)>;

ReadRecordings recordings_in_pack(const LibraryPicture& picture, const LanguageTag& language) {
    return [picture, language](const TactileMap& told) {
        std::vector<PackFinding> problems;  // the pack's importer was told
        return recordings_of(picture, told, language, problems);
    };
}

/// Its errors name the picture, and not its place on the disk.
FilePtr picture_file(const GalleryEntry& entry, const std::string& gallery_file,
                     const LanguageTag& language, MapReader read, ReadRecordings recordings = {}) {
    return std::make_shared<const PictureFile>(
        PictureFile{entry.title,
                    entry.title,
                    gallery_file,
                    false,
                    [path = entry.path, title = entry.title, language,
                     read](const PageOrder& order) -> Result<Page> {
                        auto page = open_in(path, language, order, read);
                        if (!page && page.error().line.starts_with(path))
                            return failure(title + page.error().line.substr(path.size()));
                        return page;
                    },
                    {},
                    std::move(recordings)});
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

/// What is drawn of the gallery's pictures, whatever the language.
Result<void> read_drawings(Gallery& gallery, const std::vector<GalleryEntry>& entries) {
    constexpr std::string_view attractive = "-fish.svg";
    for (const GalleryEntry& entry : entries) {
        const auto map = read_map_svg(entry.path);
        if (!map) return tl::unexpected(map.error());
        gallery.lines.push_back(std::make_shared<const LineDrawing>(line_drawing(*map)));
        if (!entry.path.ends_with(attractive)) continue;
        auto attract = attract_picture(*map);
        if (!attract) return tl::unexpected(attract.error());
        gallery.attract = std::move(*attract);
    }
    return {};
}

/// The practice shapes, and the picture of the attract screen, stay.
void leave_packs_alone(Gallery& gallery) {
    const auto count = static_cast<std::ptrdiff_t>(gallery.lines.size());
    for (auto& titles : gallery.titles) titles.erase(titles.begin(), titles.begin() + count);
    // Behind the list nobody chooses them, and practice finds its words in every language.
    for (auto& files : gallery.files)
        std::rotate(files.begin(), files.begin() + count, files.end());
    gallery.lines.clear();
}

/// True if the order is for another part or detail of what the visitor brought.
bool is_of_same_file(const LoadPicture& order, const Visitor& visitor) {
    const auto& loading = visitor.loading;
    return loading && loading->order.request == order.request &&
           loading->reason != LoadReason::other_picture &&
           (order.source == PictureSource::stick || order.source == PictureSource::camera);
}

/// Removes the file's name, which begins every line about it, tells nothing and may hold anything.
std::string told_reason(const std::string& line, const std::string& name,
                        const Language& language) {
    return told_of_file(line.starts_with(name) ? line.substr(name.size()) : line, picture_trouble,
                        language);
}

}  // namespace

Result<Gallery> read_gallery(const std::string& folder, const std::string& library,
                             const std::vector<Language>& languages, Offered offered) {
    Gallery gallery;
    for (const Language& language : languages) {
        const LanguageTag tag{language.code()};
        const auto entries = list_gallery(folder, tag);
        if (!entries) return tl::unexpected(entries.error());
        if (gallery.lines.empty()) {
            const auto drawn = read_drawings(gallery, *entries);
            if (!drawn) return tl::unexpected(drawn.error());
        }
        std::vector<GalleryTitle>& titles = gallery.titles.emplace_back();
        std::vector<FilePtr>& files = gallery.files.emplace_back();
        for (const GalleryEntry& entry : *entries) {
            titles.push_back({entry.title, entry.description, entry.difficulty});
            // The gallery is trusted: this process reads its words.
            files.push_back(
                picture_file(entry, fs::path(entry.path).filename().string(), tag, read_map_svg));
        }
        if (library.empty()) continue;
        std::vector<PackFinding> problems;  // the pack's importer was told
        for (const LibraryPicture& picture : list_library(library, tag, problems)) {
            const GalleryEntry& entry = picture.entry;
            titles.push_back(
                {entry.title, entry.description, entry.difficulty, picture.title_recording});
            files.push_back(
                picture_file(entry, "", tag, read_map_of_pack, recordings_in_pack(picture, tag)));
        }
    }
    gallery.circle = named(gallery.files.front(), "-circle.svg");
    gallery.square = named(gallery.files.front(), "-square.svg");
    if (offered == Offered::packs) leave_packs_alone(gallery);
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
            return at(stick_.empty() ? given_ : stick_, order.index);
        case PictureSource::camera:
            return photo_;
        case PictureSource::drawing:
            break;
    }
    return nullptr;
}

LineDrawingPtr Pictures::lines_of(PictureSource source, const std::string& title,
                                  std::size_t language) const {
    if (source == PictureSource::gallery && language < gallery_.titles.size()) {
        const std::vector<GalleryTitle>& titles = gallery_.titles[language];
        const auto found = std::ranges::find(titles, title, &GalleryTitle::title);
        const auto place = static_cast<std::size_t>(found - titles.begin());
        if (place < gallery_.lines.size()) return gallery_.lines[place];
    }
    const auto felt = felt_.find({source, title});
    return felt == felt_.end() ? nullptr : felt->second;
}

void Pictures::keep_lines(PictureSource source, const std::string& title, const TactileMap& map) {
    LineDrawingPtr& lines = felt_[{source, title}];
    if (!lines) lines = std::make_shared<const LineDrawing>(line_drawing(map));
}

void Pictures::put_stick(std::vector<FilePtr> files) {
    stick_ = std::move(files);
    std::erase_if(felt_, [](const auto& each) { return each.first.first == PictureSource::stick; });
}

void Pictures::forget() {
    stick_.clear();
    photo_.reset();
    felt_.clear();
}

std::optional<PictureFailed> OrderedPicture::want(const LoadPicture& order, const Visitor& visitor,
                                                  const FilePtr& listed, const Language& language) {
    order_ = order;
    const FilePtr& file = is_of_same_file(order, visitor) && felt_file_ ? felt_file_ : listed;
    if (file == nullptr)
        return PictureFailed{order.request,
                             language.text("kiosk", "This picture is gone. Choose another one.")};
    wanted_ = file;
    is_loading_ = true;
    const Zoom zoom{order.zoom.centre, order.zoom.factor};
    loader_->want(order.request,
                  {file, order.page, order.view, {order.detail, zoom}, order.thing_at});
    return std::nullopt;
}

void OrderedPicture::cancel() {
    loader_->cancel();
    stay_with_felt();
}

void OrderedPicture::stay_with_felt() {
    is_loading_ = false;
    order_ = felt_order_;
    wanted_ = felt_file_;
}

std::optional<PictureNews> OrderedPicture::take(const Delivery& delivery,
                                                const Language& language) {
    if (delivery.request != order_.request || !wanted_) return std::nullopt;
    if (!delivery.scene) return refuse(delivery, language);
    if (!std::exchange(is_loading_, false) && !delivery.is_better) return std::nullopt;
    shown_ = delivery.scene->shown;
    map_ = delivery.scene->felt.map;
    felt_file_ = wanted_;
    felt_order_ = order_;
    PictureFacts facts = facts_of(*delivery.scene, *wanted_, order_.form, language);
    parts_ = facts.parts;
    return PictureNews{PictureReady{delivery.request, std::move(facts)}, delivery.scene->felt,
                       delivery.is_better};
}

PictureNews OrderedPicture::refuse(const Delivery& delivery, const Language& language) {
    const std::string& line = delivery.scene.error().line;
    const bool is_answer = line == nothing_there;
    const std::string sentence =
        order_.thing_at
            ? language.text("trouble",
                            is_answer ? line : "The main subject cannot be looked for now.")
            : told_reason(line, wanted_->name, language);
    PictureNews news{PictureFailed{delivery.request, sentence}};
    if (!is_answer) news.line = wanted_->is_private ? "a visitor's picture cannot be felt" : line;
    stay_with_felt();
    return news;
}

PictureFacts OrderedPicture::put_drawing(std::uint64_t request, const LoadedScene& drawing,
                                         const Language& language) {
    forget();
    order_.request = request;
    order_.source = PictureSource::drawing;
    felt_order_ = order_;
    shown_ = drawing.shown;
    map_ = drawing.felt.map;
    PictureFacts facts = facts_of(drawing, PictureFile{}, {}, language);
    parts_ = facts.parts;
    return facts;
}

std::optional<std::size_t> OrderedPicture::part_at(const HandState& hand) const {
    if (!map_) return std::nullopt;
    return touchline::part_at(*map_, parts_, hand);
}

void OrderedPicture::forget() {
    loader_->forget();
    is_loading_ = false;
    wanted_.reset();
    felt_file_.reset();
    shown_ = {};
    map_.reset();
    parts_.clear();
    order_ = {};
    felt_order_ = {};
}

}  // namespace touchline
