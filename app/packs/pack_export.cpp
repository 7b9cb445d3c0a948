#include "app/packs/pack_export.h"

#include "app/decode/files.h"
#include "app/packs/plain_names.h"
#include "app/packs/unpacking.h"

#include <cstdint>

#include <zlib.h>

namespace touchline {
namespace {

/// Writes little-endian numbers, as zip files need.
class ZipWriter {
  public:
    void add(const PackFile& file) {
        const std::string_view contents(reinterpret_cast<const char*>(file.bytes.data()),
                                        file.bytes.size());
        const auto at = static_cast<std::uint32_t>(bytes_.size());
        const auto* const first = reinterpret_cast<const Bytef*>(file.bytes.data());
        const auto sum =
            static_cast<std::uint32_t>(::crc32(0, first, static_cast<uInt>(file.bytes.size())));
        const std::string fields = fields_of(sum, static_cast<std::uint32_t>(file.bytes.size()),
                                             static_cast<std::uint16_t>(file.name.size()));
        bytes_ += "PK\3\4" + fields + file.name;
        bytes_ += contents;
        constexpr std::uint16_t made_by_unix = 3U << 8U | 20U;
        list_ += "PK\1\2" + number<std::uint16_t>(made_by_unix) + fields;
        list_ += number<std::uint16_t>(0) + number<std::uint16_t>(0) + number<std::uint16_t>(0);
        list_ += number<std::uint32_t>(0100644U << 16U) + number<std::uint32_t>(at) + file.name;
        ++count_;
    }

    [[nodiscard]] std::vector<std::byte> finish() const {
        const auto at = static_cast<std::uint32_t>(bytes_.size());
        const std::string whole = bytes_ + list_ + "PK\5\6" + number<std::uint32_t>(0) +
                                  number(count_) + number(count_) +
                                  number(static_cast<std::uint32_t>(list_.size())) + number(at) +
                                  number<std::uint16_t>(0);
        const auto bytes = std::as_bytes(std::span(whole));
        return {bytes.begin(), bytes.end()};
    }

  private:
    template <class Number>
    static std::string number(Number value) {
        std::string made;
        for (std::size_t i = 0; i < sizeof value; ++i)
            made += static_cast<char>((std::uint64_t{value} >> (8U * i)) & 0xffU);
        return made;
    }

    /// The fields that a member's header and the list share. Members are stored, not packed, and
    /// dated to the first day of 1980.
    static std::string fields_of(std::uint32_t sum, std::uint32_t size, std::uint16_t name_bytes) {
        constexpr std::uint32_t first_day = 0x00210000;
        return number<std::uint16_t>(20) + number<std::uint16_t>(0) + number<std::uint16_t>(0) +
               number(first_day) + number(sum) + number(size) + number(size) + number(name_bytes) +
               number<std::uint16_t>(0);
    }

    std::string bytes_;
    std::string list_;
    std::uint16_t count_ = 0;
};

}  // namespace

std::vector<std::byte> zip_of(const Pack& pack) {
    ZipWriter writer;
    for (const PackFile& file : pack.files) writer.add(file);
    return writer.finish();
}

PackResult<Pack> with_image_layers(Pack pack, const std::string& language) {
    for (PackFile& file : pack.files) {
        if (kind_by_name(file.name) != PackFileKind::picture) continue;
        auto made = as_image_layers(file, language);
        if (!made) return refusal(made.error());
        file = std::move(*made);
    }
    return pack;
}

PackResult<void> export_pack(const std::string& folder, const std::string& zip_file) {
    const auto pack = read_pack(folder);
    if (!pack) return refusal(pack.error());
    const auto written = write_whole_file(zip_file, zip_of(*pack));
    if (!written) return refusal({FindingKind::output_unwritable, zip_file});
    return {};
}

}  // namespace touchline
