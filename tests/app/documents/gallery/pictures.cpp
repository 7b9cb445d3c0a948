#include "tests/app/documents/gallery/pictures.h"

#include "app/documents/decode/files.h"
#include "app/documents/decode/map_svg.h"
#include "app/documents/gallery/gallery.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr auto folder = TOUCHLINE_SOURCE_DIR "/app/documents/gallery/pictures";

}  // namespace

std::vector<ShippedPicture> shipped_pictures(const LanguageTag& language) {
    std::vector<ShippedPicture> pictures;
    const auto entries = list_gallery(folder).value();
    for (const GalleryEntry& entry : entries) {
        std::string text = read_text(entry.path).value();
        TactileMap map = parse_map_svg(text, language).value();
        pictures.push_back(
            {std::filesystem::path(entry.path).stem(), std::move(text), std::move(map)});
    }
    return pictures;
}

std::vector<std::string> part_names(const TactileMap& map) {
    std::vector<std::string> names;
    const Outline* path = nullptr;  // the first outline of the current path
    for (const Outline& outline : map.outlines) {
        if (path != nullptr && outline.label == path->label &&
            outline.id.starts_with(path->id + "-"))
            continue;
        path = &outline;
        names.push_back(outline.label);
    }
    return names;
}

std::string table_of_pictures() {
    std::string table = "| no. | picture | difficulty | parts |\n|---|---|---|---|\n";
    for (const ShippedPicture& picture : shipped_pictures()) {
        table += fmt::format("| {} | {} | {} | {} |\n", picture.name.substr(0, 2),
                             picture.map.title, difficulty_of_map_svg(picture.text)->value_or(0),
                             part_names(picture.map).size());
    }
    return table;
}

std::string with_table(const std::string& readme, const std::string& table) {
    const std::string first = "<!-- pictures -->\n";
    const auto begin = readme.find(first);
    const auto end = readme.find("<!-- /pictures -->");
    if (begin == std::string::npos || end == std::string::npos || end < begin) return readme;
    return readme.substr(0, begin + first.size()) + table + readme.substr(end);
}

}  // namespace touchline
