#include "app/documents/gallery/gallery.h"

#include "app/documents/decode/files.h"
#include "app/documents/decode/map_svg.h"
#include "app/documents/decode/one_line.h"
#include "app/isolation/process/places.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <system_error>

namespace touchline {
namespace {

namespace fs = std::filesystem;

Result<std::vector<std::string>> maps_in(const std::string& folder) {
    std::vector<std::string> paths;
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        if (it->path().extension() == ".svg") paths.push_back(it->path());
    }
    if (error) {
        return failure("the gallery " + one_line(folder) + " cannot be read: " + error.message() +
                       "; install the kiosk again or set TOUCHLINE_GALLERY");
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

Result<GalleryEntry> entry_of(const std::string& path, const LanguageTag& language) {
    const auto text = read_text(path);
    if (!text) return tl::unexpected(text.error());
    auto map = parse_map_svg(*text, language);
    if (!map) return failure(one_line(path) + ": " + map.error().line);
    const auto difficulty = difficulty_of_map_svg(*text);
    if (!difficulty) return failure(one_line(path) + ": " + difficulty.error().line);
    return GalleryEntry{path, std::move(map->title), std::move(map->description), *difficulty};
}

Result<std::vector<GalleryEntry>> list(const std::string& folder, const LanguageTag& language) {
    const auto paths = maps_in(folder);
    if (!paths) return tl::unexpected(paths.error());
    std::vector<GalleryEntry> entries;
    for (const std::string& path : *paths) {
        auto entry = entry_of(path, language);
        if (!entry) return tl::unexpected(entry.error());
        entries.push_back(std::move(*entry));
    }
    if (entries.empty()) {
        return failure("the gallery " + one_line(folder) +
                       " holds no .svg file; install the kiosk again or set TOUCHLINE_GALLERY");
    }
    return entries;
}

}  // namespace

Result<std::vector<GalleryEntry>> list_gallery(const std::string& folder,
                                               const LanguageTag& language) {
    try {
        return list(folder, language);
    } catch (const std::exception& problem) {
        return failure("the gallery cannot be read: " + one_line(problem.what()));
    }
}

std::string gallery_folder() {
    const std::string chosen = environment("TOUCHLINE_GALLERY");
    if (!chosen.empty()) return chosen;
    return installed_place(TOUCHLINE_GALLERY_BESIDE_PROGRAM, TOUCHLINE_GALLERY_SOURCE).string();
}

}  // namespace touchline
