#include "app/decode/decoding.h"
#include "app/decode/formats.h"

namespace touchline {
namespace decode {
namespace {

Result<Stored> refuse(Bytes bytes) {
    return not_a_picture(format_of(bytes));
}

PixelReader reader_of(FileFormat format) {
    switch (format) {
        case FileFormat::png:
            return read_png;
        case FileFormat::jpeg:
            return read_jpeg;
        case FileFormat::webp:
            return read_webp;
        case FileFormat::tiff:
            return read_tiff;
        case FileFormat::gif:
            return read_gif;
        case FileFormat::bmp:
            return read_bmp;
        case FileFormat::pnm:
            return read_pnm;
        default:
            return refuse;
    }
}

Result<Page> read_raster(Bytes bytes, const PageOrder& order) {
    return page_by(reader_of(format_of(bytes)), bytes, order);
}

}  // namespace
}  // namespace decode

Result<Page> decode_raster(std::span<const std::byte> bytes, const PageOrder& order) {
    return decode::without_exceptions(decode::read_raster, bytes, order);
}

}  // namespace touchline
