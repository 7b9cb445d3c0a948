#include "app/kiosk/stick_files.h"

#include "app/decode/opening.h"
#include "app/decode/side_car.h"
#include "app/sticks/names.h"

#include <filesystem>
#include <utility>

namespace touchline {
namespace {

Result<Page> opened(StickReader& reader, const std::string& root, const StickEntry& entry,
                    const PageOrder& order) {
    const std::string name = shown_name(entry.name);
    if (entry.kind == StickFileKind::office)
        return failure(name + ": " + std::string(office_sentence()));
    const auto bytes = reader.read(root, entry);
    if (!bytes) return failure(sentence_of(bytes.error(), name));
    auto page = open_page((*bytes)->document.bytes(), order);
    if (!page) return failure(name + ": " + page.error().line);
    if ((*bytes)->side_car) {
        const auto text = (*bytes)->side_car->bytes();
        tell(std::string_view(reinterpret_cast<const char*>(text.data()), text.size()), page->told);
    }
    return page;
}

}  // namespace

Result<StickListing, StickRefusal> StickReader::list(const std::string& root) {
    const std::lock_guard lock(mutex_);
    return import_.list(root);
}

void StickReader::forget() {
    ++stick_;
    const std::lock_guard lock(last_mutex_);
    last_.reset();
}

std::shared_ptr<const StickBytes> StickReader::last_of(const std::string& root,
                                                       const StickEntry& entry) const {
    const std::lock_guard lock(last_mutex_);
    const bool is_it =
        last_ && last_->stick == stick_ && last_->root == root && last_->entry == entry;
    return is_it ? last_ : nullptr;
}

/// Keeps the bytes unless the stick has changed since.
void StickReader::keep(const std::shared_ptr<const StickBytes>& bytes) {
    const std::lock_guard lock(last_mutex_);
    last_ = bytes->stick == stick_ ? bytes : nullptr;
}

Result<std::shared_ptr<const StickBytes>, StickRefusal> StickReader::read(const std::string& root,
                                                                          const StickEntry& entry) {
    const std::lock_guard lock(mutex_);
    if (auto known = last_of(root, entry)) return known;
    const std::uint64_t stick = stick_;
    const auto document = import_.read(root, entry);
    if (!document) return tl::unexpected(document.error());
    auto mapped = map_sealed(*document, most_bytes_of(entry.kind));
    if (!mapped) return tl::unexpected(StickRefusal::unreadable);
    auto bytes = std::make_shared<const StickBytes>(
        StickBytes{root, entry, std::move(*mapped), side_car(root, entry), stick});
    keep(bytes);
    return bytes;
}

/// Returns nothing for one that cannot be read.
std::optional<Mapping> StickReader::side_car(const std::string& root, const StickEntry& entry) {
    const auto text = import_.read_side_car(root, entry);
    if (!text) return std::nullopt;
    auto mapped = map_sealed(*text, most_side_car_bytes);
    if (!mapped) return std::nullopt;
    return std::move(*mapped);
}

std::vector<FilePtr> files_of_stick(const std::shared_ptr<StickReader>& reader,
                                    const std::string& root, const StickListing& listing) {
    std::vector<FilePtr> files;
    for (const StickEntry& entry : listing.entries) {
        const std::string stem = std::filesystem::path(entry.name).stem().string();
        files.push_back(std::make_shared<const PictureFile>(
            PictureFile{shown_name(entry.name), shown_name(stem), "", true,
                        [reader, root, entry](const PageOrder& order) {
                            return opened(*reader, root, entry, order);
                        },
                        entry.name}));
    }
    return files;
}

}  // namespace touchline
