#include "app/decode/decoding.h"
#include "app/decode/pixel_page.h"

#include <libheif/heif.h>

namespace touchline {
namespace decode {
namespace {

Result<Page> read_film(Bytes bytes, const PageOrder& order) {
    return page_by(read_heif, bytes, order);
}

}  // namespace
}  // namespace decode

void prepare_films() {
    (void)heif_init(nullptr);  // a codec that is not there is told with the file that wants it
}

Result<Page> decode_film(std::span<const std::byte> bytes, const PageOrder& order) {
    return decode::without_exceptions(decode::read_film, bytes, order);
}

}  // namespace touchline
