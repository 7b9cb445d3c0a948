#include "app/decode/pixel_page.h"

#include "app/decode/metadata.h"

#include <utility>

namespace touchline::decode {

namespace {

bool is_told(const Resolution& resolution) {
    return resolution.across > 0.0 && resolution.down > 0.0;
}

}  // namespace

Result<Page> page_by(PixelReader read, Bytes bytes, const PageOrder& order) {
    if (order.page != 1) return failure("the file has one page only");
    auto stored = read(bytes);
    if (!stored) return tl::unexpected(stored.error());
    Metadata metadata = metadata_of(bytes);
    convert_to_srgb(metadata.colour_profile, stored->picture);
    const Resolution& resolution =
        is_told(stored->resolution) ? stored->resolution : metadata.resolution;
    const int orientation = stored->orientation != 0 ? stored->orientation : metadata.orientation;
    Page page;
    page.picture = upright(with_square_pixels(std::move(stored->picture), resolution), orientation);
    page.told.area = told_area(page.picture);
    page.told.title = std::move(metadata.title);
    page.told.description = std::move(metadata.description);
    return page;
}

}  // namespace touchline::decode
