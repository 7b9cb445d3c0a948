// The pictures that ship with the kiosk: map SVGs (app/decode/map_svg.h) in one folder, whose names
// begin with a number that puts them in order. Threads: pure functions but for the files they read.
#pragma once

#include "config/types/language_tag.h"
#include "config/types/result.h"

#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// One picture of a gallery, ready to be shown in a list and read with read_map_svg.
struct GalleryEntry {
    std::string path;
    std::string title;              // of the map
    std::string description;        // the view and an overview, for a listener
    std::optional<int> difficulty;  // 1 (easy) ... 5; none: nobody graded it
};

/// The maps (*.svg) in a folder, sorted by file name, with their words in `language` (map_svg.h
/// says what is taken where a picture does not speak it). Fails with one line when the folder
/// cannot be read, holds no map, or holds one that cannot be used. O(files' sizes).
[[nodiscard]] Result<std::vector<GalleryEntry>> list_gallery(const std::string& folder,
                                                             const LanguageTag& language = {});

/// Where the gallery is: TOUCHLINE_GALLERY of the environment if it is set; else beside the program
/// as it is installed (../share/touchline/gallery) if that exists; else in the sources it was built
/// from.
[[nodiscard]] std::string gallery_folder();

}  // namespace touchline
