#include "app/decode/decoding.h"
#include "app/decode/formats.h"
#include "app/decode/metadata.h"
#include "app/decode/signature.h"

#include <utility>

namespace touchline {
namespace decode {
namespace {

Result<Picture> read_pixels(Bytes bytes) {
    const FileFormat format = format_of(bytes);
    switch (format) {
        case FileFormat::png:
            return read_png(bytes);
        case FileFormat::jpeg:
            return read_jpeg(bytes);
        case FileFormat::webp:
            return read_webp(bytes);
        case FileFormat::tiff:
            return read_tiff(bytes);
        case FileFormat::gif:
            return read_gif(bytes);
        case FileFormat::bmp:
            return read_bmp(bytes);
        case FileFormat::pnm:
            return read_pnm(bytes);
        case FileFormat::heif:
            return read_heif(bytes);
        default:
            return not_a_picture(format);
    }
}

/// TIFF's reader and libheif turn a picture themselves.
bool is_turned_by_its_reader(FileFormat format) {
    return format == FileFormat::tiff || format == FileFormat::heif;
}

Page page_of(Picture picture, Metadata metadata, FileFormat format) {
    convert_to_srgb(metadata.colour_profile, picture);
    Page page;
    page.picture = is_turned_by_its_reader(format)
                       ? std::move(picture)
                       : upright(std::move(picture), metadata.orientation);
    page.told.area = told_area(page.picture);
    page.told.title = std::move(metadata.title);
    page.told.description = std::move(metadata.description);
    return page;
}

Result<Page> read_raster(Bytes bytes, const PageOrder& order) {
    if (order.page != 1) return failure("the file has one page only");
    return read_pixels(bytes).map([bytes](Picture picture) {
        return page_of(std::move(picture), metadata_of(bytes), format_of(bytes));
    });
}

}  // namespace
}  // namespace decode

Result<Page> decode_raster(std::span<const std::byte> bytes, const PageOrder& order) {
    return decode::without_exceptions(decode::read_raster, bytes, order);
}

}  // namespace touchline
