#include "app/documents/decode/bmp_header.h"

#include <algorithm>
#include <cstdlib>

namespace touchline::decode {
namespace {

constexpr std::size_t oldest_header_bytes = 12;  // OS/2: sides of 16 bits, colours of 3 bytes

constexpr std::array<std::uint32_t, 4> fields_of_16{0x001f, 0x03e0, 0x7c00, 0};
constexpr std::array<std::uint32_t, 4> fields_of_32{0x0000ff, 0x00ff00, 0xff0000, 0};

/// The picture's header, after the file's; fields that it leaves out are 0.
class Header {
  public:
    Header(Bytes bytes, std::size_t at)
        : bytes_(bytes), at_(at), size_(little_endian(bytes, at, 4)) {}

    [[nodiscard]] bool is_known() const {
        const bool is_of_os2 = size_ >= 16 && size_ <= 64;  // it may be cut off after any field
        const bool is_of_windows = size_ == 108 || size_ == 124;
        return (is_oldest() || is_of_os2 || is_of_windows) && at_ + size_ <= bytes_.size();
    }

    [[nodiscard]] bool is_oldest() const { return size_ == oldest_header_bytes; }

    /// Windows has no header of these sizes. OS/2 uses the same numbers for other packings.
    [[nodiscard]] bool is_of_os2() const {
        return size_ <= 64 && size_ != 40 && size_ != 52 && size_ != 56;
    }

    [[nodiscard]] std::size_t size() const { return size_; }

    [[nodiscard]] std::size_t end() const { return at_ + size_; }

    [[nodiscard]] std::uint32_t number(std::size_t offset, std::size_t count) const {
        return offset + count <= size_ ? little_endian(bytes_, at_ + offset, count) : 0;
    }

  private:
    Bytes bytes_;
    std::size_t at_;
    std::size_t size_;
};

/// The packings, each with its depths.
bool read_packing(const Header& from, BmpHeader& header) {
    const auto set = [&header](BmpPacking packing, std::initializer_list<int> depths) {
        header.packing = packing;
        return std::ranges::count(depths, header.bits) > 0;
    };
    switch (from.is_oldest() ? 0 : from.number(16, 4)) {
        case 0:
            return set(BmpPacking::none, {1, 2, 4, 8, 16, 24, 32});
        case 1:
            return set(BmpPacking::runs_of_8, {8});
        case 2:
            return set(BmpPacking::runs_of_4, {4});
        case 3:  // OS/2: packed as a fax, which nobody has been seen to write
            return !from.is_of_os2() && set(BmpPacking::fields, {16, 32});
        case 4:  // Windows: a JPEG for printers
            return from.is_of_os2() && set(BmpPacking::runs_of_24, {24});
        case 6:
            return set(BmpPacking::fields, {16, 32});
        default:
            return false;
    }
}

void read_fields(Bytes bytes, const Header& from, BmpHeader& header) {
    header.fields = header.bits == 16 ? fields_of_16 : fields_of_32;
    if (header.packing != BmpPacking::fields) return;
    // The fields are in the header, or right behind a short one.
    const std::size_t first = from.end() - from.size() + 40;
    header.fields = {little_endian(bytes, first + 8, 4), little_endian(bytes, first + 4, 4),
                     little_endian(bytes, first, 4), 0};
    constexpr std::uint32_t with_alpha = 6;
    if (from.size() >= 56 || from.number(16, 4) == with_alpha)
        header.fields[3] = little_endian(bytes, first + 12, 4);
}

/// Reads the colours between the header and the pixels.
bool read_palette(Bytes bytes, const Header& from, BmpHeader& header) {
    header.end = from.end();
    if (header.bits > 8) return true;
    const std::size_t colour_bytes = from.is_oldest() ? 3 : 4;
    const std::size_t most = std::size_t{1} << static_cast<unsigned>(header.bits);
    if (header.pixels_at < header.end) return false;
    const std::size_t wanted = from.is_oldest() ? 0 : from.number(32, 4);
    std::size_t count = wanted == 0 ? most : std::min(wanted, most);
    count = std::min(count, (header.pixels_at - header.end) / colour_bytes);
    for (std::size_t i = 0; i < count; ++i, header.end += colour_bytes) {
        const auto part = [&](std::size_t offset) {
            return static_cast<std::uint8_t>(little_endian(bytes, header.end + offset, 1));
        };
        header.palette.push_back({part(0), part(1), part(2)});
    }
    header.palette.resize(most);  // black, so that no index is beyond the end
    return count > 0;
}

Result<void> read_sides(const Header& from, BmpHeader& header) {
    const std::size_t side_bytes = from.is_oldest() ? 2 : 4;
    const auto side = [&](std::size_t offset) {
        return std::int64_t{static_cast<std::int32_t>(from.number(offset, side_bytes))};
    };
    const std::int64_t width = side(4);
    const std::int64_t height = side(4 + side_bytes);  // negative: from the top down
    header.is_top_down = height < 0;
    auto fits = check_file_size("BMP", width, std::abs(height));
    if (!fits) return fits;
    header.width = static_cast<int>(width);
    header.height = static_cast<int>(std::abs(height));
    header.bits = static_cast<int>(from.number(6 + 2 * side_bytes, 2));
    return {};
}

/// Pixels per metre, or per another unit of OS/2; only their ratio counts.
Resolution resolution_of(const Header& from) {
    if (from.is_oldest()) return {};
    const auto number = [&from](std::size_t offset) {
        return static_cast<double>(static_cast<std::int32_t>(from.number(offset, 4)));
    };
    return {number(24), number(28)};
}

}  // namespace

std::uint32_t little_endian(Bytes bytes, std::size_t at, std::size_t count) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < count && at + i < bytes.size(); ++i)
        number |= std::to_integer<std::uint32_t>(bytes[at + i]) << (8 * i);
    return number;
}

Result<BmpHeader> read_bmp_header(Bytes bytes, std::size_t at) {
    const Header from(bytes, at + file_header_bytes);
    if (!from.is_known()) return damaged("BMP", "its header is unknown");
    BmpHeader header;
    header.pixels_at = little_endian(bytes, at + 10, 4);
    if (auto sides = read_sides(from, header); !sides) return tl::unexpected(sides.error());
    if (!read_packing(from, header)) return damaged("BMP", "its packing is unknown");
    read_fields(bytes, from, header);
    if (!read_palette(bytes, from, header)) return damaged("BMP", "it has no colours");
    header.resolution = resolution_of(from);
    return header;
}

}  // namespace touchline::decode
