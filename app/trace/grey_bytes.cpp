#include "app/trace/grey_bytes.h"

#include "config/types/fields.h"

#include <cstdint>

namespace touchline {

std::vector<std::byte> bytes_of(const GreyPicture& picture) {
    ByteWriter bytes;
    bytes.number(static_cast<std::uint32_t>(picture.width));
    bytes.number(static_cast<std::uint32_t>(picture.height));
    bytes.raw(std::as_bytes(std::span(picture.grey)));
    return bytes.take();
}

Result<GreyPicture> grey_of(std::span<const std::byte> all) {
    ByteReader bytes(all);
    const auto width = bytes.number<std::uint32_t>();
    const auto height = bytes.number<std::uint32_t>();
    if (!bytes.is_good() || !fits_a_picture(width, height) ||
        bytes.left() != std::size_t{width} * height)
        return failure("the picture's parts do not fit together");
    GreyPicture picture{static_cast<int>(width), static_cast<int>(height), {}};
    const auto* const first = reinterpret_cast<const std::uint8_t*>(all.last(bytes.left()).data());
    picture.grey.assign(first, first + bytes.left());
    return picture;
}

}  // namespace touchline
