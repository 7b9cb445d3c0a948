// What touchline-unpack answers, as bytes. Nobody who reads them trusts them.
//
//   header    magic u32, layout u8, difficulty u8, findings u16, entries u16
//   findings  kind u8, line i32, value f64, file and what: bytes u16, text
//   entries   name: bytes u16, text; contents: bytes u32, bytes
//
// Little-endian, no offsets. Threads: pure functions.
#pragma once

#include "app/packs/pack.h"

#include <cstddef>
#include <span>
#include <vector>

namespace touchline {

struct UnpackAnswer {
    int difficulty = 0;  // of a picture, 1 ... 5; 0: it does not say
    std::vector<PackFinding> findings;
    std::vector<PackFile> entries;

    friend bool operator==(const UnpackAnswer&, const UnpackAnswer&) = default;
};

inline constexpr std::size_t most_findings = 200;
inline constexpr std::size_t most_finding_text_bytes = 300;

/// Findings beyond most_findings are left out; texts are cut and made fit for a line. O(bytes).
[[nodiscard]] std::vector<std::byte> bytes_of(const UnpackAnswer& answer);

/// Fails unless it is exactly what bytes_of() gives for some answer: texts are sound, names plain
/// and each there once, numbers finite, every byte used. O(bytes).
[[nodiscard]] Result<UnpackAnswer> unpack_answer_of(std::span<const std::byte> bytes);

}  // namespace touchline
