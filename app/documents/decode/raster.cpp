#include "app/documents/decode/readers.h"
#include "app/documents/decode/worker_program.h"

#include <algorithm>
#include <array>
#include <utility>

namespace touchline {
namespace decode {
namespace {

using FormatReader = std::pair<FileFormat, PixelReader>;

constexpr std::array<FormatReader, 7> readers{{{FileFormat::png, read_png},
                                               {FileFormat::jpeg, read_jpeg},
                                               {FileFormat::webp, read_webp},
                                               {FileFormat::tiff, read_tiff},
                                               {FileFormat::gif, read_gif},
                                               {FileFormat::bmp, read_bmp},
                                               {FileFormat::pnm, read_pnm}}};

Result<Stored> refuse(Bytes bytes) {
    return not_a_picture(format_of(bytes));
}

Result<Page> read_raster(Bytes bytes, const PageOrder& order) {
    const auto* const found = std::ranges::find(readers, format_of(bytes), &FormatReader::first);
    return page_by(found == readers.end() ? refuse : found->second, bytes, order);
}

}  // namespace
}  // namespace decode

Result<Page> decode_raster(std::span<const std::byte> bytes, const PageOrder& order) {
    return decode::without_exceptions(decode::read_raster, bytes, order);
}

}  // namespace touchline
