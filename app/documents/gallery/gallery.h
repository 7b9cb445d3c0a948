// The pictures that ship with the kiosk: map SVGs (app/documents/decode/map_svg.h) in one folder.
// Their names begin with a number that gives their order. Threads: pure functions, except that they
// read files.
#pragma once

#include "config/types/choices.h"
#include "config/types/result.h"

#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// One picture of a gallery, ready to be shown in a list and read with read_map_svg.
struct GalleryEntry {
    std::string path;
    std::string title;              // the map's
    std::string description;        // the view and an overview, for a listener
    std::optional<int> difficulty;  // 1 (easy) ... 5; none: ungraded
};

/// The maps (*.svg) in a folder, sorted by file name, with their words in `language` (map_svg.h
/// tells what is used if a picture does not have it). Fails with one line if the folder cannot be
/// read, holds no map, or holds an unusable one. O(files' sizes).
[[nodiscard]] Result<std::vector<GalleryEntry>> list_gallery(const std::string& folder,
                                                             const LanguageTag& language = {});

/// The gallery's folder: TOUCHLINE_GALLERY of the environment if it is set; else
/// ../share/touchline/gallery beside the installed program if that exists; else the one in the
/// sources.
[[nodiscard]] std::string gallery_folder();

}  // namespace touchline
