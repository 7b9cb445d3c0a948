#include "app/documents/decode/drawing_surface.h"

#include "app/documents/decode/formats.h"

#include <algorithm>

namespace touchline::decode {

DrawingSurface::DrawingSurface(int width, int height)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height)),
      context_(cairo_create(surface_.get())) {}

Result<Picture> DrawingSurface::picture() const {
    if (const auto status = cairo_status(context_.get()); status != CAIRO_STATUS_SUCCESS)
        return failure(std::string("the file cannot be drawn (") + cairo_status_to_string(status) +
                       "); save it as PNG");
    cairo_surface_flush(surface_.get());
    Picture picture;
    picture.width = cairo_image_surface_get_width(surface_.get());
    picture.height = cairo_image_surface_get_height(surface_.get());
    const std::size_t row_bytes = std::size_t{4} * static_cast<std::size_t>(picture.width);
    picture.bgr.resize(row_bytes * static_cast<std::size_t>(picture.height));
    const unsigned char* row = cairo_image_surface_get_data(surface_.get());
    const int stride = cairo_image_surface_get_stride(surface_.get());
    std::uint8_t* to = picture.bgr.data();
    // ARGB32 is one number per pixel, blue lowest, colours multiplied by alpha.
    for (int y = 0; y < picture.height; ++y, row += stride) {
        std::copy_n(row, row_bytes, to);
        for (std::size_t x = 0; x < row_bytes; x += 4) unmultiply(to + x);
        to += row_bytes;
    }
    compose(picture.bgr);
    return picture;
}

}  // namespace touchline::decode
