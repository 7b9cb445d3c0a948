// The pictures of app/gallery/pictures, for the tests that look at each of them and for the table
// and the sheet that show them all. Threads: pure functions but for the files they read.
#pragma once

#include "config/types/language_tag.h"
#include "config/types/tactile_map.h"

#include <string>
#include <vector>

namespace touchline {

struct ShippedPicture {
    std::string name;  // of the file, without .svg
    std::string text;  // the file
    TactileMap map;    // in the language
};

/// Sorted by name. Throws where one cannot be read.
[[nodiscard]] std::vector<ShippedPicture> shipped_pictures(const LanguageTag& language = {});

/// What has a name of its own: the subpaths of a path are one part. O(outlines^2).
[[nodiscard]] std::vector<std::string> part_names(const TactileMap& map);

/// Markdown: number, title, difficulty and how many parts, a picture a row.
[[nodiscard]] std::string table_of_pictures();

/// The README with what stands between its lines `<!-- pictures -->` and `<!-- /pictures -->`
/// replaced; as it is where it lacks them.
[[nodiscard]] std::string with_table(const std::string& readme, const std::string& table);

}  // namespace touchline
