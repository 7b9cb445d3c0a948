// Packs, zip files and recordings, good and evil, made for the tests.
#pragma once

#include "app/packs/pack.h"

#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace touchline::made {

using Bytes = std::vector<std::byte>;

[[nodiscard]] Bytes bytes_of(std::string_view text);
[[nodiscard]] std::string text_of(const Bytes& bytes);

/// One member of a zip file, every field as it is written; nothing is corrected.
struct Member {
    std::string name;
    std::string contents;
    std::uint16_t flags = 0;
    unsigned made_by = 3;  // Unix
    std::uint32_t attributes = 0100644U << 16U;
    std::uint32_t claimed_bytes = 0xffffffff;  // 0xffffffff: as many as there are
    bool is_deflated = false;                  // zeros in place of the contents' bytes
    std::string local_name;                    // empty: as name
};

/// The raw bytes, list and end included.
[[nodiscard]] Bytes zip(const std::vector<Member>& members);

/// `name` with `count` zeros, deflated: a thousandth of them.
[[nodiscard]] Member zeros(const std::string& name, std::size_t count);

/// A pack.toml and one picture.
[[nodiscard]] std::vector<Member> small_pack();

/// Mono, a tone of 440 Hz. `format`: of libsndfile, SF_FORMAT_WAV | SF_FORMAT_PCM_16 and so on.
[[nodiscard]] Bytes recording(int format, int rate_Hz, double length_s, int channels = 1,
                              float loudness = 0.5F);

[[nodiscard]] Bytes ogg();

/// One to eight bytes changed, or a piece cut out or cut off.
[[nodiscard]] Bytes mutated(Bytes bytes, std::mt19937& random);

/// Every page of an Ogg file gets the sum that its bytes have.
void mend_ogg_sums(Bytes& bytes);

/// Few a day; as many as TOUCHLINE_MUTATIONS says for the hazard table.
[[nodiscard]] int mutation_count(int a_day);

/// A folder of its own, gone with it.
class Folder {
  public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::string path() const { return path_.string(); }

    void write(const std::string& name, const Bytes& bytes) const;

  private:
    std::filesystem::path path_;
};

/// The pack that the guide shows.
[[nodiscard]] std::string example_pack();

}  // namespace touchline::made
