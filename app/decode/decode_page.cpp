#include "app/decode/decode_page.h"

#include "app/decode/formats.h"
#include "app/decode/picture.h"

#include <string_view>

namespace touchline {
namespace {

constexpr std::string_view words_in_a_drawing =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9">)"
    R"(<text font-family="serif">a<tspan font-weight="bold">b</tspan></text>)"
    R"(<text font-family="sans-serif">a<tspan font-weight="bold">b</tspan></text>)"
    R"(<text font-family="monospace">a<tspan font-weight="bold">b</tspan></text></svg>)";

}  // namespace

void prepare_libraries(WorkerKind kind) {
    if (kind != WorkerKind::document) return;
    decode::silence_libraries();
    (void)decode::read_svg(std::as_bytes(std::span(words_in_a_drawing)));
}

Result<Page> decode_page(std::span<const std::byte> bytes, const PageOrder& order) {
    if (order.page != 1) return failure("the file has one page only");
    return decode_picture(bytes).and_then([](Picture picture) -> Result<Page> {
        const auto width = static_cast<std::uint64_t>(picture.width);
        const auto height = static_cast<std::uint64_t>(picture.height);
        if (!fits_a_page(width, height))
            return failure(
                "the picture has more than 40 megapixels or 10000 on a side; "
                "save it smaller");
        Page page;
        page.picture = std::move(picture);
        return page;
    });
}

}  // namespace touchline
