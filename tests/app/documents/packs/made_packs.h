// Packs, zip files and recordings, good and evil, for the tests.
#pragma once

#include "app/documents/packs/pack.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace touchline::made {

using Bytes = std::vector<std::byte>;

[[nodiscard]] Bytes bytes_of(std::string_view text);
[[nodiscard]] std::string text_of(const Bytes& bytes);

/// One member of a zip file; every field is written as it is, and nothing is corrected.
struct Member {
    std::string name;
    std::string contents;
    std::uint16_t flags = 0;
    unsigned made_by = 3;  // Unix
    std::uint32_t attributes = 0100644U << 16U;
    std::uint32_t claimed_bytes = 0xffffffff;  // 0xffffffff: the true number
    bool is_deflated = false;                  // then the contents are zeros
    std::string local_name;                    // empty: same as name
};

/// Returns the raw bytes of a zip file, with its list and its end.
[[nodiscard]] Bytes zip(const std::vector<Member>& members);

/// Returns a member of `count` zeros, deflated to about a thousandth.
[[nodiscard]] Member zeros(const std::string& name, std::size_t count);

/// Returns a pack.toml and one picture.
[[nodiscard]] std::vector<Member> small_pack();

/// Returns a tone, the same in every channel. `format`: libsndfile's, such as
/// SF_FORMAT_WAV | SF_FORMAT_PCM_16.
[[nodiscard]] Bytes recording(int format, int rate_Hz, double length_s, int channels = 1,
                              float loudness = 0.5F, float tone_Hz = 440.0F);

[[nodiscard]] Bytes ogg();

/// Gives every page of an Ogg file the checksum of its bytes.
void mend_ogg_sums(Bytes& bytes);

/// Returns a few for each day's test run; TOUCHLINE_MUTATIONS sets more for the hazard table.
[[nodiscard]] int mutation_count(int a_day);

/// Returns the path of the pack that the guide shows.
[[nodiscard]] std::string example_pack();

}  // namespace touchline::made
