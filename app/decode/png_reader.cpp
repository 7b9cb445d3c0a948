#include "app/decode/formats.h"

#include <png.h>

namespace touchline::decode {
namespace {

/// Frees what libpng's simplified interface holds; it never longjmps into us.
class Image : public png_image {
  public:
    Image() : png_image{} { version = PNG_IMAGE_VERSION; }

    Image(const Image&) = delete;
    Image(Image&&) = delete;
    Image& operator=(const Image&) = delete;
    Image& operator=(Image&&) = delete;

    ~Image() { png_image_free(this); }
};

std::uint64_t big_endian_32(Bytes bytes, std::size_t offset) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value = value << 8U | std::to_integer<std::uint64_t>(bytes[offset + i]);
    }
    return value;
}

}  // namespace

Result<Picture> read_png(Bytes bytes) {
    constexpr std::size_t header_end = 24;  // signature 8, IHDR's length and name 8, two sides 8
    if (bytes.size() < header_end) return damaged("PNG", "the header is missing");
    // Looked at here because libpng calls a large header merely invalid.
    if (auto fits = check_size("PNG", big_endian_32(bytes, 16), big_endian_32(bytes, 20)); !fits) {
        return tl::unexpected(fits.error());
    }

    Image image;
    if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) {
        return damaged("PNG", image.message);
    }
    const bool has_alpha = (image.format & PNG_FORMAT_FLAG_ALPHA) != 0;
    const std::size_t channels = has_alpha ? 4 : 3;
    if (auto fits = check_size("PNG", image.width, image.height); !fits) {
        return tl::unexpected(fits.error());
    }
    image.format = has_alpha ? PNG_FORMAT_BGRA : PNG_FORMAT_BGR;
    image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // 16 bits are no reason to take it for linear light
    Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
    picture.bgr.resize(channels * image.width * image.height);
    if (png_image_finish_read(&image, nullptr, picture.bgr.data(), 0, nullptr) == 0) {
        return damaged("PNG", image.message);
    }
    if (has_alpha) compose(picture.bgr);
    return picture;
}

}  // namespace touchline::decode
