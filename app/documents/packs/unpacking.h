// Opens untrusted packs, and writes zip files, by touchline-unpack, which can do nothing else.
// Threads: any, each call by itself; a call waits for its worker, at most its deadline.
#pragma once

#include "app/documents/packs/pack.h"
#include "audio-cues/speech/recording.h"
#include "config/types/tactile_map.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace touchline {

/// The files of a zip file, sorted by name, without litter and without a single folder around all.
[[nodiscard]] PackResult<std::vector<PackFile>> unpack_zip(std::span<const std::byte> zip);

/// The pack as a zip file, with names in order and no dates. The same pack gives the same bytes,
/// and reading them gives the same files, bit for bit. Fails if it is larger than a zip file may
/// be. O(bytes).
[[nodiscard]] PackResult<std::vector<std::byte>> zip_of(const Pack& pack);

struct PackSoundLook {
    VoiceRecording recording;
    std::vector<PackFinding> findings;  // gaps and hints
};

/// Opens WAV, OGG (Vorbis, Opus) or FLAC of at most pack_limits.sound_s.
[[nodiscard]] PackResult<PackSoundLook> open_sound(const PackFile& file);

struct PackPictureLook {
    TactileMap map;  // in the first language
    std::optional<int> difficulty;
    std::vector<PackFinding> findings;  // gaps and hints
};

/// Opens a map SVG, or a layered picture of the IMAGE project, which is fitted to the drawing area.
/// `languages`: at least one, each an is_language_tag(). A text that is missing in one of them is a
/// gap.
[[nodiscard]] PackResult<PackPictureLook> open_picture(const PackFile& file,
                                                       const std::vector<std::string>& languages);

/// The picture as a layered picture of the IMAGE project, in one language (map_svg.h).
[[nodiscard]] PackResult<PackFile> as_image_layers(const PackFile& file,
                                                   const std::string& language);

}  // namespace touchline
