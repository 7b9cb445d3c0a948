#include "app/documents/decode/file_format.h"
#include "app/documents/decode/formats.h"
#include "app/documents/decode/pdf_words.h"
#include "app/documents/decode/worker_program.h"

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
