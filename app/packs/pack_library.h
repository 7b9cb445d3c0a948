// The packs that are installed: one folder each in one folder, unpacked, named by their id.
// Threads: one at a time for a library; the functions wait for workers.
#pragma once

#include "app/gallery/gallery.h"
#include "app/packs/pack.h"
#include "config/types/language_tag.h"
#include "config/types/tactile_map.h"

#include <cstdint>
#include <string>
#include <vector>

namespace touchline {

/// ask: a pack that is older than the installed one is not taken but told as `older`.
enum class OlderPack : std::uint8_t { ask, take };

/// Checks the pack and installs it: into a folder beside, flushed, then renamed, so that the
/// library holds the old version or the new one and never a half. `library` is made if missing.
/// Returns the folder of the pack.
[[nodiscard]] PackResult<std::string> import_pack(const Pack& pack, const std::string& library,
                                                  OlderPack older = OlderPack::ask);

/// One picture of an installed pack; `entry` as of the gallery, but read it with read_pack_map().
struct LibraryPicture {
    std::string pack;        // its id
    std::string pack_title;  // in the language
    GalleryEntry entry;
};

/// All pictures of all packs, packs by id, pictures as pack.toml lists them. What cannot be used is
/// left out and told in `problems`. A library that is not there is empty.
[[nodiscard]] std::vector<LibraryPicture> list_library(const std::string& library,
                                                       const LanguageTag& language,
                                                       std::vector<PackFinding>& problems);

/// The map of a LibraryPicture, by a worker: no byte of it is parsed here but as of map_bytes.h.
[[nodiscard]] PackResult<TactileMap> read_pack_map(const std::string& path,
                                                   const LanguageTag& language);

/// A text of a picture that somebody recorded: what RecordedPrompts::add() takes.
struct RecordedText {
    std::string language;
    std::string text;
    std::vector<float> samples;  // mono at 48 000 Hz, full scale 1
};

/// All of one picture in one language.
[[nodiscard]] std::vector<RecordedText> recorded_texts(const LibraryPicture& picture,
                                                       const LanguageTag& language,
                                                       std::vector<PackFinding>& problems);

/// Where packs are installed for this user: TOUCHLINE_LIBRARY of the environment, else
/// XDG_DATA_HOME or .local/share of the home, with touchline/packs.
[[nodiscard]] std::string library_folder();

}  // namespace touchline
