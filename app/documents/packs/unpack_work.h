// The pieces of work of touchline-unpack: a zip file, a recording, a picture of a pack. The bytes
// may be anything. Threads: pure functions; one thread for libarchive and libsndfile.
#pragma once

#include "app/documents/packs/pack.h"
#include "app/documents/packs/unpack_answer.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// A file by the list at the end of a zip file.
struct ZipMember {
    std::string name;
    std::uint32_t bytes = 0;  // unpacked, by the file's own claim
};

/// The files in the order of the list; leaves out folders and litter (plain_names.h). Refuses a
/// file that is no zip file or has more than one disk, locked members, links, devices, names that
/// are not plain or occur twice, and sizes and counts beyond pack_limits. O(bytes).
[[nodiscard]] PackResult<std::vector<ZipMember>> zip_members(std::span<const std::byte> zip);

/// All or nothing. Fails as zip_members() does, and for a member that holds more than it claims,
/// has a wrong checksum, is a packed file itself, or is of a kind that no pack holds.
[[nodiscard]] PackResult<std::vector<PackFile>> files_in_zip(std::span<const std::byte> zip);

/// The files as a zip file that files_in_zip() takes: stored, not packed, without dates and owners,
/// so that the same files give the same bytes. Fails if there is no memory. O(bytes).
[[nodiscard]] PackResult<std::vector<std::byte>> zip_with(std::span<const PackFile> files);

struct ReadSound {
    std::vector<std::int16_t> samples;  // mono at 48 000 Hz, full scale 32767
    std::vector<PackFinding> findings;
};

/// Reads WAV, OGG or FLAC of one or two channels (mixed down) at 8 to 192 kHz, at most
/// pack_limits.sound_s long. The findings do not name the file. O(samples).
[[nodiscard]] PackResult<ReadSound> read_sound(std::span<const std::byte> bytes);

/// Entry map_entry: map_bytes.h, in the first language. Findings do not name the file. A refusal
/// comes alone. O(text + points).
[[nodiscard]] UnpackAnswer check_picture(std::string_view svg,
                                         const std::vector<std::string>& languages);

/// Entry picture_entry: app/documents/decode/image_layers.h.
[[nodiscard]] UnpackAnswer picture_in_layers(std::string_view svg, const std::string& language);

}  // namespace touchline
