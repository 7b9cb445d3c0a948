#include "app/documents/decode/files.h"
#include "app/documents/decode/one_line.h"
#include "app/documents/decode/picture.h"

#include <vector>

#include <png.h>

namespace touchline {
namespace {

Result<void> write(const std::string& path, int width, int height, png_uint_32 format,
                   std::span<const std::uint8_t> pixels) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.format = format;
    if (width < 1 || height < 1 ||
        pixels.size() != std::size_t{PNG_IMAGE_SAMPLE_CHANNELS(format)} *
                             static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
        return failure(one_line(path) + ": cannot be written: the picture has no pixels");
    }
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::vector<std::byte> bytes(size);
    if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr) == 0) {
        return failure(one_line(path) + ": cannot be written as PNG: " + one_line(image.message));
    }
    return write_whole_file(path, std::span(bytes).first(size));
}

}  // namespace

Result<void> write_png(const std::string& path, const Picture& picture) {
    return write(path, picture.width, picture.height, PNG_FORMAT_BGR, picture.bgr);
}

Result<void> write_png(const std::string& path, const GreyView& picture) {
    return write(path, picture.width, picture.height, PNG_FORMAT_GRAY, picture.pixels);
}

}  // namespace touchline
