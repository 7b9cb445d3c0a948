#include "app/screen/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace touchline {

namespace {

/// Copies row by row. Cairo's pixels are B, G, R and one more byte (little endian).
void copy_rows(const std::uint8_t* bgr, std::size_t bgr_stride, cairo_surface_t* surface) {
    unsigned char* const pixels = cairo_image_surface_get_data(surface);
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
    const auto width = static_cast<std::size_t>(cairo_image_surface_get_width(surface));
    const auto height = static_cast<std::size_t>(cairo_image_surface_get_height(surface));
    for (std::size_t y = 0; y < height; ++y) {
        const std::uint8_t* from = bgr + y * bgr_stride;
        unsigned char* to = pixels + y * stride;
        for (std::size_t x = 0; x < width; ++x, from += 3, to += 4) {
            std::memcpy(to, from, 3);
            to[3] = 255;
        }
    }
    cairo_surface_mark_dirty(surface);
}

}  // namespace

Canvas::Canvas(int width, int height)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height)),
      context_(cairo_create(surface_.get())) {}

int Canvas::width() const {
    return cairo_image_surface_get_width(surface_.get());
}

int Canvas::height() const {
    return cairo_image_surface_get_height(surface_.get());
}

const unsigned char* Canvas::pixels() const {
    cairo_surface_flush(surface_.get());
    return cairo_image_surface_get_data(surface_.get());
}

int Canvas::stride() const {
    return cairo_image_surface_get_stride(surface_.get());
}

Canvas canvas_of(const Picture& picture, int longest_px) {
    Canvas whole = canvas_of_frame(picture.bgr, picture.width, picture.height,
                                   3 * static_cast<std::size_t>(picture.width));
    const double scale = static_cast<double>(longest_px) / std::max(picture.width, picture.height);
    if (scale >= 1.0) return whole;
    const auto scaled = [scale](int size) {
        return std::max(1, static_cast<int>(std::lround(scale * size)));
    };
    Canvas small(scaled(picture.width), scaled(picture.height));
    cairo_t* const cr = small.context();
    cairo_scale(cr, static_cast<double>(small.width()) / picture.width,
                static_cast<double>(small.height()) / picture.height);
    cairo_set_source_surface(cr, whole.surface(), 0.0, 0.0);
    cairo_pattern_set_filter(cairo_get_source(cr), CAIRO_FILTER_GOOD);
    cairo_pattern_set_extend(cairo_get_source(cr), CAIRO_EXTEND_PAD);
    cairo_paint(cr);
    return small;
}

Canvas canvas_of_frame(std::span<const std::uint8_t> bgr, int width, int height,
                       std::size_t stride) {
    Canvas canvas(width, height);
    copy_rows(bgr.data(), stride, canvas.surface());
    return canvas;
}

Picture picture_of(const Canvas& canvas) {
    Picture picture;
    picture.width = canvas.width();
    picture.height = canvas.height();
    const auto width = static_cast<std::size_t>(picture.width);
    const auto height = static_cast<std::size_t>(picture.height);
    picture.bgr.resize(3 * width * height);
    const unsigned char* const pixels = canvas.pixels();
    for (std::size_t y = 0; y < height; ++y) {
        const unsigned char* from = pixels + y * static_cast<std::size_t>(canvas.stride());
        std::uint8_t* to = picture.bgr.data() + 3 * y * width;
        for (std::size_t x = 0; x < width; ++x, from += 4, to += 3) std::memcpy(to, from, 3);
    }
    return picture;
}

}  // namespace touchline
