// The answer of touchline-unpack, as bytes; the files that it makes a zip file of come to it in the
// same form. No reader trusts it.
//
//   header    magic u32, layout u8, difficulty u8, findings u16, entries u16
//   findings  kind u8, line i32, value f64, file and what: bytes u16, text
//   entries   name: bytes u16, text; contents: bytes u32, bytes
//
// Little-endian, no offsets. Threads: pure functions.
#pragma once

#include "app/documents/packs/pack.h"

#include <cstddef>
#include <span>
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

}  // namespace touchline
