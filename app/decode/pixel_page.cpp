#include "app/decode/pixel_page.h"

#include "app/decode/metadata.h"

#include <utility>

namespace touchline::decode {

Result<Page> page_by(const PixelReader& reader, Bytes bytes, const PageOrder& order) {
    if (order.page != 1) return failure("the file has one page only");
    auto picture = reader.read(bytes);
    if (!picture) return tl::unexpected(picture.error());
    Metadata metadata = metadata_of(bytes);
    convert_to_srgb(metadata.colour_profile, *picture);
    Page page;
    page.picture = reader.is_turning ? std::move(*picture)
                                     : upright(std::move(*picture), metadata.orientation);
    page.told.area = told_area(page.picture);
    page.told.title = std::move(metadata.title);
    page.told.description = std::move(metadata.description);
    return page;
}

}  // namespace touchline::decode
