#include "app/decode/white_sheet.h"

#include <algorithm>

namespace touchline::decode {

WhiteSheet::WhiteSheet(int width, int height)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
      context_(cairo_create(surface_.get())) {
    cairo_set_source_rgb(context_.get(), 1.0, 1.0, 1.0);
    cairo_paint(context_.get());
}

Result<Picture> WhiteSheet::picture() const {
    if (const auto status = cairo_status(context_.get()); status != CAIRO_STATUS_SUCCESS)
        return failure(std::string("the file cannot be drawn (") + cairo_status_to_string(status) +
                       "); save it as PNG");
    cairo_surface_flush(surface_.get());
    Picture picture;
    picture.width = cairo_image_surface_get_width(surface_.get());
    picture.height = cairo_image_surface_get_height(surface_.get());
    picture.bgr.resize(std::size_t{3} * static_cast<std::size_t>(picture.width) *
                       static_cast<std::size_t>(picture.height));
    const unsigned char* row = cairo_image_surface_get_data(surface_.get());
    const int stride = cairo_image_surface_get_stride(surface_.get());
    std::uint8_t* to = picture.bgr.data();
    // RGB24 is one number a pixel, blue lowest.
    for (int y = 0; y < picture.height; ++y, row += stride)
        for (int x = 0; x < picture.width; ++x, to += 3)
            std::copy_n(row + std::size_t{4} * static_cast<std::size_t>(x), 3, to);
    return picture;
}

}  // namespace touchline::decode
