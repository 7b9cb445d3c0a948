#include "app/documents/decode/drawing_surface.h"
#include "app/documents/decode/file_format.h"
#include "app/documents/decode/pdf_words.h"
#include "app/documents/decode/readers.h"
#include "app/documents/decode/worker_program.h"

#include <algorithm>
#include <string>
#include <string_view>

#include <glib.h>

namespace touchline {
namespace decode {
namespace {

constexpr std::string_view words_in_a_drawing =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9">)"
    R"(<text font-family="serif">a<tspan font-weight="bold">b</tspan></text>)"
    R"(<text font-family="sans-serif">a<tspan font-weight="bold">b</tspan></text>)"
    R"(<text font-family="monospace">a<tspan font-weight="bold">b</tspan></text></svg>)";

void silence_libraries() {
    g_log_set_writer_func(
        [](GLogLevelFlags, const GLogField*, gsize, gpointer) { return G_LOG_WRITER_HANDLED; },
        nullptr, nullptr);
}

Result<Page> read_document(Bytes bytes, const PageOrder& order) {
    const FileFormat format = format_of(bytes);
    if (format == FileFormat::svg) return read_svg(bytes, order);
    if (format == FileFormat::pdf) return read_pdf(bytes, order);
    return not_a_picture(format);
}

}  // namespace

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

}  // namespace decode

void prepare_documents() {
    decode::silence_libraries();
    decode::prepare_pdf();
    (void)decode::read_svg(std::as_bytes(std::span(decode::words_in_a_drawing)), {});
}

Result<Page> decode_document(std::span<const std::byte> bytes, const PageOrder& order) {
    return decode::without_exceptions(decode::read_document, bytes, order);
}

}  // namespace touchline
