#include "app/decode/bmp_header.h"

#include <algorithm>
#include <cstdlib>

namespace touchline::decode {
namespace {

constexpr std::size_t file_header_bytes = 14;
constexpr std::size_t oldest_header_bytes = 12;  // OS/2: sides of 16 bits, colours of 3 bytes

constexpr std::array<std::uint32_t, 4> fields_of_16{0x001f, 0x03e0, 0x7c00, 0};
constexpr std::array<std::uint32_t, 4> fields_of_32{0x0000ff, 0x00ff00, 0xff0000, 0};

bool is_known(std::size_t header_bytes) {
    constexpr std::array<std::size_t, 7> known{oldest_header_bytes, 40, 52, 56, 64, 108, 124};
    return std::find(known.begin(), known.end(), header_bytes) != known.end();
}

/// The four ways of packing, with the depths that they are for.
bool read_packing(std::uint32_t number, BmpHeader& header) {
    const auto is = [&header](std::initializer_list<int> depths) {
        return std::find(depths.begin(), depths.end(), header.bits) != depths.end();
    };
    switch (number) {
        case 0:
            header.packing = BmpPacking::none;
            return is({1, 4, 8, 16, 24, 32});
        case 1:
            header.packing = BmpPacking::runs_of_8;
            return is({8});
        case 2:
            header.packing = BmpPacking::runs_of_4;
            return is({4});
        case 3:
        case 6:
            header.packing = BmpPacking::fields;
            return is({16, 32});
        default:
            return false;
    }
}

void read_fields(Bytes bytes, std::size_t header_bytes, std::uint32_t packing, BmpHeader& header) {
    header.fields = header.bits == 16 ? fields_of_16 : fields_of_32;
    if (header.packing != BmpPacking::fields) return;
    const std::size_t first = file_header_bytes + 40;  // in the header, or right behind a short one
    header.fields = {little_endian(bytes, first + 8, 4), little_endian(bytes, first + 4, 4),
                     little_endian(bytes, first, 4), 0};
    if (header_bytes >= 56 || packing == 6) header.fields[3] = little_endian(bytes, first + 12, 4);
}

/// Colours between the header and the pixels.
bool read_palette(Bytes bytes, std::size_t header_bytes, std::size_t wanted, BmpHeader& header) {
    if (header.bits > 8) return true;
    const std::size_t colour_bytes = header_bytes == oldest_header_bytes ? 3 : 4;
    const std::size_t most = std::size_t{1} << static_cast<unsigned>(header.bits);
    const std::size_t first = file_header_bytes + header_bytes;
    if (header.pixels_at < first) return false;
    std::size_t count = wanted == 0 ? most : std::min(wanted, most);
    count = std::min(count, (header.pixels_at - first) / colour_bytes);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = first + i * colour_bytes;
        const auto part = [&](std::size_t offset) {
            return static_cast<std::uint8_t>(little_endian(bytes, at + offset, 1));
        };
        header.palette.push_back({part(0), part(1), part(2)});
    }
    header.palette.resize(most);  // black: no index is beyond the end
    return count > 0;
}

Result<void> read_sides(Bytes bytes, bool is_oldest, BmpHeader& header) {
    const std::size_t at = file_header_bytes + 4;
    const std::size_t side_bytes = is_oldest ? 2 : 4;
    const auto width =
        std::int64_t{static_cast<std::int32_t>(little_endian(bytes, at, side_bytes))};
    const auto height =
        std::int64_t{static_cast<std::int32_t>(little_endian(bytes, at + side_bytes, side_bytes))};
    if (width <= 0) return damaged("BMP", "it has no pixels");
    header.is_top_down = height < 0;
    auto fits = check_size("BMP", static_cast<std::uint64_t>(width),
                           static_cast<std::uint64_t>(std::abs(height)));
    if (!fits) return fits;
    header.width = static_cast<int>(width);
    header.height = static_cast<int>(std::abs(height));
    header.bits = static_cast<int>(little_endian(bytes, at + 2 * side_bytes + 2, 2));
    return {};
}

}  // namespace

std::uint32_t little_endian(Bytes bytes, std::size_t at, std::size_t count) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < count && at + i < bytes.size(); ++i)
        number |= std::to_integer<std::uint32_t>(bytes[at + i]) << (8 * i);
    return number;
}

Result<BmpHeader> read_bmp_header(Bytes bytes) {
    const std::size_t header_bytes = little_endian(bytes, file_header_bytes, 4);
    if (!is_known(header_bytes) || bytes.size() < file_header_bytes + header_bytes)
        return damaged("BMP", "its header is unknown");
    const bool is_oldest = header_bytes == oldest_header_bytes;
    BmpHeader header;
    header.pixels_at = little_endian(bytes, 10, 4);
    if (auto sides = read_sides(bytes, is_oldest, header); !sides)
        return tl::unexpected(sides.error());
    const std::uint32_t packing = is_oldest ? 0 : little_endian(bytes, file_header_bytes + 16, 4);
    if (!read_packing(packing, header)) return damaged("BMP", "its packing is unknown");
    read_fields(bytes, header_bytes, packing, header);
    const std::uint32_t colours = is_oldest ? 0 : little_endian(bytes, file_header_bytes + 32, 4);
    if (!read_palette(bytes, header_bytes, colours, header))
        return damaged("BMP", "it has no colours");
    return header;
}

}  // namespace touchline::decode
