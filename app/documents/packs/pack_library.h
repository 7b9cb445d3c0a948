// The installed packs: in one folder, each unpacked in a folder named by its id.
// Threads: one at a time for a library; the functions wait for workers.
#pragma once

#include "app/documents/gallery/gallery.h"
#include "app/documents/packs/pack.h"
#include "app/documents/packs/picture_recordings.h"
#include "audio-cues/speech/recording.h"
#include "config/types/choices.h"
#include "config/types/tactile_map.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace touchline {

/// ask: refuses a pack that is older than the installed one, with the finding `older`.
enum class OlderPack : std::uint8_t { ask, take };

/// Checks the pack and installs it: writes a folder beside, flushes it, then renames it, so that
/// the library holds the old version or the new one and never a half. Makes `library` if it is
/// missing. Returns the pack's folder.
[[nodiscard]] PackResult<std::string> import_pack(const Pack& pack, const std::string& library,
                                                  OlderPack older = OlderPack::ask);

/// The folders of all installed packs, by their ids. A missing library is empty.
[[nodiscard]] std::vector<std::filesystem::path> installed_packs(
    const std::filesystem::path& library);

/// What the table of the pack in this folder says.
[[nodiscard]] PackResult<PackInfo> installed_info(const std::filesystem::path& folder);

/// One picture of an installed pack. `entry` is as in the gallery, but read it with
/// read_pack_map().
struct LibraryPicture {
    std::string pack;  // its id
    GalleryEntry entry;
    /// Of the title, in the language, if it is short (if_short()); else null.
    VoiceRecordingPtr title_recording = {};
};

/// All pictures of all packs, packs by id, pictures in the order of pack.toml. Leaves out what
/// cannot be used and reports it in `problems`. A missing library is empty. Holds recorded titles
/// of list_recorded_s at most, those of the first pictures.
[[nodiscard]] std::vector<LibraryPicture> list_library(const std::string& library,
                                                       const LanguageTag& language,
                                                       std::vector<PackFinding>& problems);

/// The map of a LibraryPicture, read by a worker: this process parses its bytes only as
/// map_bytes.h.
[[nodiscard]] PackResult<TactileMap> read_pack_map(const std::string& path,
                                                   const LanguageTag& language);

inline constexpr double list_recorded_s = 300.0;     // of the titles of a list: 29 MB
inline constexpr double picture_recorded_s = 300.0;  // of all recordings of one picture

/// What is recorded of the picture in the language, or else in another form of it ("de-AT" for
/// "de"), each read by a worker. `told`: its map, as read_pack_map() gives it. A recording of a
/// text that the map lacks is left out, for it could not be shown; so is one beyond
/// picture_recorded_s, in the order title, description, parts. Null: there is none. What cannot
/// be read is reported in `problems`.
[[nodiscard]] PictureRecordingsPtr recordings_of(const LibraryPicture& picture,
                                                 const TactileMap& told,
                                                 const LanguageTag& language,
                                                 std::vector<PackFinding>& problems);

/// The folder of this user's packs: TOUCHLINE_LIBRARY of the environment, else touchline/packs in
/// XDG_DATA_HOME or in the home's .local/share.
[[nodiscard]] std::string library_folder();

}  // namespace touchline
