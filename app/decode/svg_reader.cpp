// An SVG as a picture of pixels. librsvg opens no other file as long as it is told of no base
// address; scripts, animation and network do not exist in it, and it bounds its own nesting.
#include "app/decode/formats.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <cairo.h>
#include <librsvg/rsvg.h>

namespace touchline::decode {
namespace {

struct Release {
    void operator()(RsvgHandle* handle) const { g_object_unref(handle); }

    void operator()(GError* error) const { g_error_free(error); }

    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }

    void operator()(cairo_t* context) const { cairo_destroy(context); }
};

template <class T>
using Owned = std::unique_ptr<T, Release>;

struct Size {
    int width;
    int height;
};

/// The document's proportions with the longer side svg_longer_side_px long; 4:3 when it names none.
Size drawn_size(RsvgHandle* handle) {
    double width = 0.0;
    double height = 0.0;
    if (rsvg_handle_get_intrinsic_size_in_pixels(handle, &width, &height) == 0) {
        gboolean has_box = 0;
        RsvgRectangle box{};
        rsvg_handle_get_intrinsic_dimensions(handle, nullptr, nullptr, nullptr, nullptr, &has_box,
                                             &box);
        width = has_box != 0 ? box.width : 4.0;
        height = has_box != 0 ? box.height : 3.0;
    }
    const double longer = std::max(width, height);
    if (!(width > 0.0 && height > 0.0 && std::isfinite(longer))) return {0, 0};
    const auto side = [&](double length) {
        return std::max(1, static_cast<int>(std::lround(length / longer * svg_longer_side_px)));
    };
    return {side(width), side(height)};
}

/// cairo's RGB24 is one number a pixel, blue lowest.
void copy_rows(cairo_surface_t* surface, Picture& picture) {
    cairo_surface_flush(surface);
    const unsigned char* row = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    std::uint8_t* to = picture.bgr.data();
    for (int y = 0; y < picture.height; ++y, row += stride) {
        const unsigned char* from = row;
        for (int x = 0; x < picture.width; ++x, from += 4, to += 3) std::copy_n(from, 3, to);
    }
}

tl::unexpected<Error> told(const Owned<GError>& error) {
    return damaged("SVG", error != nullptr ? error->message : "it cannot be drawn");
}

}  // namespace

Result<Picture> read_svg(Bytes bytes) {
    GError* problem = nullptr;
    const Owned<RsvgHandle> handle(rsvg_handle_new_from_data(
        reinterpret_cast<const guint8*>(bytes.data()), bytes.size(), &problem));
    if (handle == nullptr) return told(Owned<GError>(problem));
    const Size size = drawn_size(handle.get());
    if (auto fits = check_size("SVG", static_cast<std::uint64_t>(size.width),
                               static_cast<std::uint64_t>(size.height), 4);
        !fits) {
        return tl::unexpected(fits.error());
    }
    const Owned<cairo_surface_t> surface(
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.width, size.height));
    const Owned<cairo_t> context(cairo_create(surface.get()));
    cairo_set_source_rgb(context.get(), 1.0, 1.0, 1.0);
    cairo_paint(context.get());
    const RsvgRectangle whole{0.0, 0.0, static_cast<double>(size.width),
                              static_cast<double>(size.height)};
    if (rsvg_handle_render_document(handle.get(), context.get(), &whole, &problem) == 0) {
        return told(Owned<GError>(problem));
    }
    if (cairo_status(context.get()) != CAIRO_STATUS_SUCCESS) {
        return damaged("SVG", cairo_status_to_string(cairo_status(context.get())));
    }
    Picture picture{size.width, size.height, {}};
    picture.bgr.resize(std::size_t{3} * static_cast<std::size_t>(size.width) *
                       static_cast<std::size_t>(size.height));
    copy_rows(surface.get(), picture);
    return picture;
}

void silence_libraries() {
    g_log_set_writer_func(
        [](GLogLevelFlags, const GLogField*, gsize, gpointer) { return G_LOG_WRITER_HANDLED; },
        nullptr, nullptr);
}

}  // namespace touchline::decode
