// An SVG as a picture of pixels. librsvg opens no other file as long as it is told of no base
// address; scripts, animation and network do not exist in it, and it bounds its own nesting.
#include "app/decode/formats.h"
#include "app/decode/map_svg.h"
#include "app/decode/svg_references.h"
#include "app/decode/white_sheet.h"
#include "config/types/map_limits.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <librsvg/rsvg.h>

namespace touchline::decode {
namespace {

struct Release {
    void operator()(RsvgHandle* handle) const { g_object_unref(handle); }

    void operator()(GError* error) const { g_error_free(error); }
};

template <class T>
using Owned = std::unique_ptr<T, Release>;

struct Size {
    int width;
    int height;
};

/// The document's proportions with the longer side svg_longer_side_px long; 4:3 when it names none.
Size drawn_size(RsvgHandle* handle) {
    double width = 0.0;
    double height = 0.0;
    if (rsvg_handle_get_intrinsic_size_in_pixels(handle, &width, &height) == 0) {
        gboolean has_box = 0;
        RsvgRectangle box{};
        rsvg_handle_get_intrinsic_dimensions(handle, nullptr, nullptr, nullptr, nullptr, &has_box,
                                             &box);
        width = has_box != 0 ? box.width : 4.0;
        height = has_box != 0 ? box.height : 3.0;
    }
    const double longer = std::max(width, height);
    if (!(width > 0.0 && height > 0.0 && std::isfinite(longer))) return {0, 0};
    const auto side = [&](double length) {
        return std::max(1, static_cast<int>(std::lround(length / longer * svg_longer_side_px)));
    };
    return {side(width), side(height)};
}

/// Its lines, where lines are what it is made of; else what it says of itself.
TactileMap told_by(std::string_view text, const Picture& picture) {
    auto drawing = parse_line_drawing(text, Area{});
    if (drawing && point_count(*drawing) <= MapLimits::points) return std::move(*drawing);
    TactileMap told;
    told.area = told_area(picture);
    SvgWords words = words_of_svg(text);
    told.title = std::move(words.title);
    told.description = std::move(words.description);
    return told;
}

tl::unexpected<Error> told(const Owned<GError>& error) {
    return damaged("SVG", error != nullptr ? error->message : "it cannot be drawn");
}

}  // namespace

Result<Page> read_svg(Bytes bytes, const PageOrder& order) {
    if (order.page != 1) return failure("the file has one page only");
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (drawn_again(text) > most_drawn_again)
        return failure("the SVG picture repeats its parts too often; save it as PNG");
    GError* problem = nullptr;
    const Owned<RsvgHandle> handle(rsvg_handle_new_from_data(
        reinterpret_cast<const guint8*>(bytes.data()), bytes.size(), &problem));
    if (handle == nullptr) return told(Owned<GError>(problem));
    const Size size = drawn_size(handle.get());
    if (auto fits = check_size("SVG", static_cast<std::uint64_t>(size.width),
                               static_cast<std::uint64_t>(size.height));
        !fits) {
        return tl::unexpected(fits.error());
    }
    const WhiteSheet sheet(size.width, size.height);
    const RsvgRectangle whole{0.0, 0.0, static_cast<double>(size.width),
                              static_cast<double>(size.height)};
    if (rsvg_handle_render_document(handle.get(), sheet.context(), &whole, &problem) == 0)
        return told(Owned<GError>(problem));
    return sheet.picture().map([text](Picture picture) {
        Page page;
        page.picture = std::move(picture);
        page.told = told_by(text, page.picture);
        return page;
    });
}

}  // namespace touchline::decode
