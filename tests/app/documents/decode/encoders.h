// Encodes files in memory for tests that read them back, with the format libraries, not with our
// code.
#pragma once

#include "app/documents/decode/picture.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace touchline::encoders {

using Bytes = std::vector<std::byte>;

/// A colourful picture that looks different in each of the eight orientations.
Picture test_picture(int width = 23, int height = 17);

struct PngForm {
    int colour_type;  // PNG_COLOR_TYPE_...
    int bit_depth;
    bool is_interlaced = false;
    std::vector<std::uint8_t> palette_rgb{};    // three entries a colour
    std::vector<std::uint8_t> palette_alpha{};  // one entry a colour
};

/// `samples` as PNG stores them (RGB order, big-endian, rows padded to bytes).
Bytes png(int width, int height, const PngForm& form, const std::vector<std::uint8_t>& samples);
Bytes png(const Picture& picture);

struct JpegForm {
    int channels = 3;  // per sample: 1 grey, 3 RGB, 4 CMYK
    bool is_progressive = false;
    bool has_adobe_marker = true;  // only for CMYK
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
    std::uint32_t subfile_type = 0;  // FILETYPE_...: its relation to another picture
};

/// `samples`: width x height x samples_per_pixel; 16-bit samples in the machine's byte order.
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
    int orientation = 1;            // EXIF numbering, stored as irot and imir
    std::uint32_t pixel_width = 1;  // the pixel's shape, stored as pasp
    std::uint32_t pixel_height = 1;
    int quality = 90;
};

Bytes heif(const Picture& picture, const HeifForm& form);

/// Returns the same pixels in RGB order.
std::vector<std::uint8_t> rgb_of(const Picture& picture);

Bytes bytes_of(const std::string& text);

}  // namespace touchline::encoders
