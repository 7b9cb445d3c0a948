// The pictures of app/documents/gallery/pictures, for tests of each of them and for the table and
// the sheet that show them all. Threads: pure functions except for the files they read.
#pragma once

#include "config/types/choices.h"
#include "config/types/tactile_map.h"

#include <string>
#include <vector>

namespace touchline {

struct ShippedPicture {
    std::string name;  // the file's name without .svg
    std::string text;  // the file's text
    TactileMap map;    // in the requested language
};

/// Returns the pictures sorted by name. Throws if one cannot be read.
[[nodiscard]] std::vector<ShippedPicture> shipped_pictures(const LanguageTag& language = {});

/// Returns the names of parts: the subpaths of a path are one part. O(outlines^2).
[[nodiscard]] std::vector<std::string> part_names(const TactileMap& map);

/// Returns a Markdown table with a row for each picture: number, title, difficulty and number of
/// parts.
[[nodiscard]] std::string table_of_pictures();

/// Returns the README with the text between its lines `<!-- pictures -->` and `<!-- /pictures -->`
/// replaced; unchanged if it lacks them.
[[nodiscard]] std::string with_table(const std::string& readme, const std::string& table);

}  // namespace touchline
