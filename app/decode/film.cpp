#include "app/decode/decoding.h"
#include "app/decode/pixel_page.h"

namespace touchline {
namespace decode {
namespace {

Result<Page> read_film(Bytes bytes, const PageOrder& order) {
    return page_by({read_heif, true}, bytes, order);
}

}  // namespace
}  // namespace decode

Result<Page> decode_film(std::span<const std::byte> bytes, const PageOrder& order) {
    return decode::without_exceptions(decode::read_film, bytes, order);
}

}  // namespace touchline
