// EXIF and TIFF number the eight ways of holding a camera alike: TIFF 6.0, tag 274.
#include "app/decode/formats.h"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>

namespace touchline::decode {
namespace {

constexpr std::uint16_t orientation_tag = 0x0112;

/// Numbers of a TIFF structure, every access checked; 0 beyond the end.
class TiffNumbers {
  public:
    explicit TiffNumbers(Bytes bytes) : bytes_(bytes), is_big_endian_(byte_at(0) == 'M') {}

    [[nodiscard]] std::uint32_t read_16(std::size_t offset) const {
        const std::uint32_t a = byte_at(offset);
        const std::uint32_t b = byte_at(offset + 1);
        return is_big_endian_ ? (a << 8U) | b : (b << 8U) | a;
    }

    [[nodiscard]] std::uint32_t read_32(std::size_t offset) const {
        const std::uint32_t a = read_16(offset);
        const std::uint32_t b = read_16(offset + 2);
        return is_big_endian_ ? (a << 16U) | b : (b << 16U) | a;
    }

  private:
    [[nodiscard]] std::uint32_t byte_at(std::size_t offset) const {
        return offset < bytes_.size() ? std::to_integer<std::uint32_t>(bytes_[offset]) : 0;
    }

    Bytes bytes_;
    bool is_big_endian_;
};

}  // namespace

int exif_orientation(Bytes app1) {
    constexpr std::string_view signature("Exif\0\0", 6);
    if (app1.size() < signature.size()) return 1;
    if (std::memcmp(app1.data(), signature.data(), signature.size()) != 0) return 1;
    const TiffNumbers numbers(app1.subspan(signature.size()));
    const std::size_t directory = numbers.read_32(4);
    const std::uint32_t entries = numbers.read_16(directory);
    for (std::uint32_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + std::size_t{12} * i;
        if (numbers.read_16(entry) == orientation_tag) {
            const auto value = static_cast<int>(numbers.read_16(entry + 8));
            return value >= 1 && value <= 8 ? value : 1;
        }
    }
    return 1;
}

Picture upright(Picture picture, int orientation) {
    if (orientation < 2 || orientation > 8) return picture;
    const bool is_turned = orientation >= 5;  // rows of the file are columns of the picture
    const bool is_x_mirrored =
        orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool is_y_mirrored =
        orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    Picture out{picture.width, picture.height, {}, picture.scale};
    if (is_turned) std::swap(out.width, out.height);
    out.bgr.resize(picture.bgr.size());
    const auto width = static_cast<std::size_t>(picture.width);
    const auto height = static_cast<std::size_t>(picture.height);
    std::uint8_t* to = out.bgr.data();
    for (std::size_t y = 0; y < static_cast<std::size_t>(out.height); ++y) {
        for (std::size_t x = 0; x < static_cast<std::size_t>(out.width); ++x, to += 3) {
            // Source column and row, before the mirroring that is told in the file's own axes.
            const std::size_t column = is_turned ? y : x;
            const std::size_t row = is_turned ? x : y;
            const std::size_t from_x = is_x_mirrored ? width - 1 - column : column;
            const std::size_t from_y = is_y_mirrored ? height - 1 - row : row;
            std::copy_n(&picture.bgr[3 * (from_y * width + from_x)], 3, to);
        }
    }
    return out;
}

}  // namespace touchline::decode
