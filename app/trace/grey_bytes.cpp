#include "app/trace/grey_bytes.h"

#include "config/types/fields.h"

#include <cstdint>

namespace touchline {
namespace {

template <class Fields, class Grey>
void grey_fields(Fields& f, Grey& picture) {
    f.number(picture.width);
    f.number(picture.height);
}

}  // namespace

std::vector<std::byte> bytes_of(const GreyPicture& picture) {
    ByteWriter bytes;
    grey_fields(bytes, picture);
    bytes.raw(std::as_bytes(std::span(picture.grey)));
    return bytes.take();
}

Result<GreyPicture> grey_of(std::span<const std::byte> all) {
    ByteReader bytes(all);
    GreyPicture picture;
    grey_fields(bytes, picture);
    const auto width = static_cast<std::uint64_t>(picture.width);
    const auto height = static_cast<std::uint64_t>(picture.height);
    if (!bytes.is_good() || !fits_a_picture(width, height) || bytes.left() != width * height)
        return failure("the picture's parts do not fit together");
    const auto grey = bytes.raw(bytes.left());
    const auto* const first = reinterpret_cast<const std::uint8_t*>(grey.data());
    picture.grey.assign(first, first + grey.size());
    return picture;
}

}  // namespace touchline
