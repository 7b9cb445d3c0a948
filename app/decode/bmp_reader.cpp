// BMP, by hand: no library of Debian reads it from memory without dragging sound, windows or a
// hundred formats along. Fuzzed (tests/fuzz/bmp_fuzz.cpp), and only ever run shut in.
#include "app/decode/bmp_header.h"

#include <algorithm>
#include <bit>

namespace touchline::decode {
namespace {

/// A part of a packed pixel as 0 ... 255.
std::uint8_t part_of(std::uint32_t pixel, std::uint32_t field) {
    if (field == 0) return 0;
    const int shift = std::countr_zero(field);
    const std::uint64_t most = field >> static_cast<unsigned>(shift);
    const std::uint64_t value = (pixel & field) >> static_cast<unsigned>(shift);
    return static_cast<std::uint8_t>((value * 255 + most / 2) / most);
}

/// Where row `y` of the file belongs in the picture.
std::size_t row_at(const BmpHeader& header, int y) {
    const int row = header.is_top_down ? y : header.height - 1 - y;
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(header.width);
}

Picture picture_of(const BmpHeader& header, std::size_t channels) {
    Picture picture{header.width, header.height, {}};
    picture.bgr.resize(channels * static_cast<std::size_t>(header.width) *
                       static_cast<std::size_t>(header.height));
    return picture;
}

/// Indices, a byte each, into colours.
Picture coloured(const BmpHeader& header, const std::vector<std::uint8_t>& indices) {
    Picture picture = picture_of(header, 3);
    for (std::size_t i = 0; i < indices.size(); ++i)
        std::copy_n(header.palette[indices[i]].data(), 3, &picture.bgr[3 * i]);
    return picture;
}

std::vector<std::uint8_t> unpacked_indices(Bytes pixels, std::size_t stride,
                                           const BmpHeader& header) {
    const auto width = static_cast<std::size_t>(header.width);
    const auto bits = static_cast<std::size_t>(header.bits);
    const std::uint32_t mask = (1U << bits) - 1U;
    std::vector<std::uint8_t> indices(width * static_cast<std::size_t>(header.height));
    for (int y = 0; y < header.height; ++y) {
        const Bytes row = pixels.subspan(static_cast<std::size_t>(y) * stride, stride);
        std::uint8_t* to = &indices[row_at(header, y)];
        for (std::size_t x = 0; x < width; ++x) {
            const auto byte = std::to_integer<std::uint32_t>(row[x * bits / 8]);
            to[x] = static_cast<std::uint8_t>(byte >> (8 - bits - x * bits % 8) & mask);
        }
    }
    return indices;
}

Picture unpacked_colours(Bytes pixels, std::size_t stride, const BmpHeader& header) {
    const auto width = static_cast<std::size_t>(header.width);
    const std::size_t pixel_bytes = static_cast<std::size_t>(header.bits) / 8;
    Picture picture = picture_of(header, 4);
    bool has_alpha = false;
    for (int y = 0; y < header.height; ++y) {
        const Bytes row = pixels.subspan(static_cast<std::size_t>(y) * stride, stride);
        std::uint8_t* to = &picture.bgr[4 * row_at(header, y)];
        for (std::size_t x = 0; x < width; ++x, to += 4) {
            const std::uint32_t pixel = little_endian(row, x * pixel_bytes, pixel_bytes);
            for (std::size_t part = 0; part < 4; ++part)
                to[part] = part_of(pixel, header.fields[part]);
            has_alpha = has_alpha || to[3] != 0;
        }
    }
    if (!has_alpha)  // no field for it, or a program that left it empty
        for (std::size_t i = 3; i < picture.bgr.size(); i += 4) picture.bgr[i] = 0xff;
    compose(picture.bgr);
    return picture;
}

/// Runs of equal pixels, and stretches of different ones.
class RunReader {
  public:
    RunReader(Bytes packed, const BmpHeader& header)
        : packed_(packed),
          header_(header),
          is_4_bit_(header.packing == BmpPacking::runs_of_4),
          indices_(static_cast<std::size_t>(header.width) *
                   static_cast<std::size_t>(header.height)) {}

    /// False when the file ends before the picture does.
    bool read() {
        while (at_ + 2 <= packed_.size()) {
            const unsigned count = take();
            const unsigned value = take();
            if (count > 0) {
                for (unsigned i = 0; i < count; ++i) put(nibble(value, i));
            } else if (value == 0) {
                x_ = 0;
                ++y_;
            } else if (value == 1) {
                return true;
            } else if (value == 2) {
                x_ += static_cast<int>(take());
                y_ += static_cast<int>(take());
            } else {
                take_stretch(value);
            }
            if (y_ > header_.height) return true;
        }
        return y_ >= header_.height;
    }

    [[nodiscard]] const std::vector<std::uint8_t>& indices() const { return indices_; }

  private:
    unsigned take() {
        return at_ < packed_.size() ? std::to_integer<unsigned>(packed_[at_++]) : 0U;
    }

    [[nodiscard]] std::uint8_t nibble(unsigned value, unsigned i) const {
        if (!is_4_bit_) return static_cast<std::uint8_t>(value);
        return static_cast<std::uint8_t>(i % 2 == 0 ? value >> 4U : value & 15U);
    }

    void take_stretch(unsigned count) {
        const std::size_t bytes = is_4_bit_ ? (count + 1) / 2 : count;
        unsigned value = 0;
        for (unsigned i = 0; i < count; ++i) {
            if (!is_4_bit_ || i % 2 == 0) value = take();
            put(nibble(value, i));
        }
        if (bytes % 2 == 1) (void)take();  // to an even number
    }

    void put(std::uint8_t index) {
        if (x_ < header_.width && y_ < header_.height)
            indices_[row_at(header_, y_) + static_cast<std::size_t>(x_)] = index;
        if (x_ < header_.width) ++x_;
    }

    Bytes packed_;
    const BmpHeader& header_;
    bool is_4_bit_;
    std::vector<std::uint8_t> indices_;
    std::size_t at_ = 0;
    int x_ = 0;
    int y_ = 0;
};

}  // namespace

Result<Picture> read_bmp(Bytes bytes) {
    const auto header = read_bmp_header(bytes);
    if (!header) return tl::unexpected(header.error());
    if (header->pixels_at > bytes.size()) return damaged("BMP", "it ends before its pixels");
    const Bytes pixels = bytes.subspan(header->pixels_at);
    if (header->packing == BmpPacking::runs_of_8 || header->packing == BmpPacking::runs_of_4) {
        RunReader runs(pixels, *header);
        if (!runs.read()) return damaged("BMP", "the file ends before the picture");
        return coloured(*header, runs.indices());
    }
    const std::size_t stride =
        (static_cast<std::size_t>(header->width) * static_cast<std::size_t>(header->bits) + 31) /
        32 * 4;
    if (pixels.size() < stride * static_cast<std::size_t>(header->height))
        return damaged("BMP", "the file ends before the picture");
    if (header->bits <= 8) return coloured(*header, unpacked_indices(pixels, stride, *header));
    return unpacked_colours(pixels, stride, *header);
}

}  // namespace touchline::decode
