// Any bytes that a worker gives to another, or gets from the kiosk, are the value that they should
// be or are refused: found lines, main things, a grey picture, a camera's frame. The first byte
// says which.
#include "app/documents/trace/finding_things.h"
#include "app/documents/trace/traced.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

namespace {

using namespace touchline;

void demand(bool is_so) {
    if (!is_so) abort();
}

bool is_whole(const GreyPicture& picture) {
    return picture.width > 0 && picture.height > 0 &&
           picture.grey.size() ==
               static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
}

bool is_finite_line(const Chain& chain) {
    return std::ranges::all_of(chain.points, [](const EdgePoint& point) {
        return std::isfinite(point.at.x) && std::isfinite(point.at.y);
    });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const auto bytes = std::as_bytes(std::span(data, size)).subspan(1);
    if (data[0] % 4 == 0) {
        const auto found = found_of(bytes);
        demand(!found || std::ranges::all_of(found->lines.chains, is_finite_line));
        demand(!found || std::ranges::equal(bytes_of(*found), bytes));
    } else if (data[0] % 4 == 1) {
        const auto things = main_things_of(bytes);
        demand(!things || is_whole(things->mask));
        demand(!things || std::ranges::all_of(things->boxes,
                                              [](const ThingBox& box) { return is_sound(box); }));
    } else if (data[0] % 4 == 2) {
        const auto grey = grey_of(bytes);
        demand(!grey || is_whole(*grey));
    } else {
        const auto frame = frame_of(bytes);
        demand(!frame || frame->stride_bytes <= size);
    }
    return 0;
}
