// The pieces of work of touchline-unpack: a zip file, a recording, a picture of a pack, and whether
// a hand can tell the lines of its map apart; and its answer as bytes. The files that it makes a
// zip file of come to it in the same form. No reader trusts it.
//
//   header    magic u32, layout u8, difficulty u8, findings u16, entries u16
//   findings  kind u8, line i32, value f64, file and what: bytes u16, text
//   entries   name: bytes u16, text; contents: bytes u32, bytes
//
// Little-endian, no offsets. Threads: pure functions; one thread for libarchive and libsndfile.
#pragma once

#include "app/documents/packs/pack.h"
#include "config/types/tactile_map.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

struct UnpackAnswer {
    int difficulty = 0;  // of a picture, 1 ... 5; 0: unknown
    std::vector<PackFinding> findings;
    std::vector<PackFile> entries;

    friend bool operator==(const UnpackAnswer&, const UnpackAnswer&) = default;
};

/// The names of entries that are no files of a pack.
inline constexpr const char* map_entry = "map";
inline constexpr const char* sound_entry = "pcm";
inline constexpr const char* picture_entry = "svg";
inline constexpr const char* zip_entry = "zip";

inline constexpr std::size_t most_findings = 200;
inline constexpr std::size_t most_finding_text_bytes = 300;

/// Leaves out findings beyond most_findings; cuts texts and makes them fit for a line. O(bytes).
[[nodiscard]] std::vector<std::byte> bytes_of(const UnpackAnswer& answer);

/// Fails unless the bytes are exactly what bytes_of() gives for some answer: texts are sound, names
/// plain and unique, numbers finite, every byte is used. O(bytes).
[[nodiscard]] Result<UnpackAnswer> unpack_answer_of(std::span<const std::byte> bytes);

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

/// Entry picture_entry: app/documents/decode/map_svg.h.
[[nodiscard]] UnpackAnswer picture_in_layers(std::string_view svg, const std::string& language);

inline constexpr double least_gap_m = 0.003;  // 1/8 inch: the least gap that a finger can feel
inline constexpr double least_rim_m = 0.003;

struct NearLines {
    std::size_t one = 0;  // indices of the map's outlines; equal: two places of one
    std::size_t other = 0;
    double gap_m = 0.0;
};

/// Every pair of outlines that come nearer than least_gap_m without meeting there, and every
/// outline that comes so near to itself; nearest first, at most `most`. Lines that meet may be near
/// each other within 8 mm of the meeting. Near-linear in the lines' length for a map with room;
/// examines at most 200 000 places.
[[nodiscard]] std::vector<NearLines> near_lines(const TactileMap& map, std::size_t most);

/// The number of parts. Outlines of the same label, and of the same id except for its suffix -2,
/// -3, ..., are one part. O(n log n).
[[nodiscard]] std::size_t part_count(const TactileMap& map);

/// The length of all outlines together.
[[nodiscard]] double line_length_m(const TactileMap& map);

/// The most parts that a picture of this difficulty (1 ... 5) should have
/// (app/documents/gallery/README.md).
[[nodiscard]] int most_parts(int difficulty);

[[nodiscard]] bool is_near_rim(const Outline& outline, const Area& area);

}  // namespace touchline
