// Files in memory to be read back, made with the format libraries themselves, not with our code.
#pragma once

#include "app/decode/picture.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace touchline::encoders {

using Bytes = std::vector<std::byte>;

/// Colourful, and different under each of the eight orientations.
Picture test_picture(int width = 23, int height = 17);

struct PngForm {
    int colour_type;  // PNG_COLOR_TYPE_...
    int bit_depth;
    bool is_interlaced = false;
    std::vector<std::uint8_t> palette_rgb{};    // three a colour
    std::vector<std::uint8_t> palette_alpha{};  // one a colour
};

/// `samples` as PNG stores them (RGB order, big-endian, rows padded to bytes).
Bytes png(int width, int height, const PngForm& form, const std::vector<std::uint8_t>& samples);
Bytes png(const Picture& picture);

struct JpegForm {
    int channels = 3;  // of the samples: 1 grey, 3 RGB, 4 CMYK
    bool is_progressive = false;
    bool has_adobe_marker = true;  // for CMYK
    int exif_orientation = 0;      // 0: no EXIF
    int quality = 95;
};

Bytes jpeg(int width, int height, const JpegForm& form, const std::vector<std::uint8_t>& samples);
Bytes jpeg(const Picture& picture, const JpegForm& form = {});

Bytes lossless_webp(int width, int height, const std::vector<std::uint8_t>& bgra);
Bytes lossy_webp(const Picture& picture);
Bytes moving_webp(const Picture& picture);

struct TiffForm {
    int photometric;
    int samples_per_pixel;
    int bits_per_sample = 8;
    int compression = 5;  // LZW
    int orientation = 1;
    int extra_sample = -1;                     // EXTRASAMPLE_... of the last sample
    std::vector<std::uint16_t> palette_rgb{};  // all reds, all greens, all blues; 256 each
    int pages = 1;
    std::uint32_t subfile_type = 0;  // FILETYPE_..., what it is of another picture
};

/// `samples`: width x height x samples_per_pixel, 16-bit ones in the machine's order.
Bytes tiff(int width, int height, const TiffForm& form, const std::vector<std::uint8_t>& samples);
Bytes tiff(const Picture& picture, int orientation = 1);

struct TiffDirectory {
    int width;
    int height;
    TiffForm form;
    std::vector<std::uint8_t> samples;
};

Bytes tiff(const std::vector<TiffDirectory>& directories);

struct HeifForm {
    bool is_avif = false;
    int orientation = 1;            // as EXIF numbers them, by irot and imir
    std::uint32_t pixel_width = 1;  // its shape, by pasp
    std::uint32_t pixel_height = 1;
    int quality = 90;
};

Bytes heif(const Picture& picture, const HeifForm& form);

/// The same pixels in RGB order.
std::vector<std::uint8_t> rgb_of(const Picture& picture);

Bytes bytes_of(const std::string& text);

}  // namespace touchline::encoders
