#include "app/trace/main_things.h"

#include "app/trace/grey_bytes.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace touchline {
namespace {

struct ThingsHeader {
    std::uint32_t magic = 0;
    std::uint32_t is_sure = 0;
    std::uint32_t boxes = 0;
    std::uint32_t mask = 0;
    FigureSigns signs;
};

constexpr std::uint32_t things_magic = 0x31474946;  // "FIG1"
constexpr std::uint32_t most_things = 20;           // none is smaller than a twentieth of all

tl::unexpected<Error> not_safe() {
    return failure("its main thing could not be found safely");
}

bool is_share(double number) {
    return number >= 0.0 && number <= 1.0;
}

bool is_sound(const ThingBox& box) {
    return is_share(box.left) && is_share(box.top) && is_share(box.right) && is_share(box.bottom) &&
           box.left < box.right && box.top < box.bottom;
}

bool is_sound(const ThingsHeader& header, std::size_t bytes) {
    const FigureSigns& signs = header.signs;
    return header.magic == things_magic && header.is_sure <= 1 && header.boxes <= most_things &&
           is_share(signs.area) && is_share(signs.contrast) &&
           sizeof header + std::size_t{header.boxes} * sizeof(ThingBox) + header.mask == bytes;
}

}  // namespace

MainThings main_things_of(const Figures& figures) {
    MainThings things;
    things.mask = {
        figures.mask.cols, figures.mask.rows, {figures.mask.begin(), figures.mask.end()}};
    const double width = figures.mask.cols;
    const double height = figures.mask.rows;
    for (const cv::Rect& box : figures.boxes) {
        things.boxes.push_back(
            {box.x / width, box.y / height, box.br().x / width, box.br().y / height});
    }
    things.signs = figures.signs;
    things.is_sure = figures.is_sure;
    return things;
}

std::vector<std::byte> bytes_of(const MainThings& things) {
    const std::vector<std::byte> mask = bytes_of(things.mask);
    const ThingsHeader header{things_magic, things.is_sure ? 1U : 0U,
                              static_cast<std::uint32_t>(things.boxes.size()),
                              static_cast<std::uint32_t>(mask.size()), things.signs};
    std::vector<std::byte> bytes;
    for (const auto part :
         {std::as_bytes(std::span(&header, 1)), std::as_bytes(std::span(things.boxes)),
          std::span(mask).first(mask.size())})
        bytes.insert(bytes.end(), part.begin(), part.end());
    return bytes;
}

Result<MainThings> main_things_of(std::span<const std::byte> bytes) {
    ThingsHeader header;
    if (bytes.size() < sizeof header) return not_safe();
    std::memcpy(&header, bytes.data(), sizeof header);
    if (!is_sound(header, bytes.size())) return not_safe();
    MainThings things;
    things.boxes.resize(header.boxes);
    const auto boxes = bytes.subspan(sizeof header, things.boxes.size() * sizeof(ThingBox));
    std::ranges::copy(boxes, std::as_writable_bytes(std::span(things.boxes)).begin());
    auto mask = grey_of(bytes.last(header.mask));
    const bool are_sound =
        std::ranges::all_of(things.boxes, [](const ThingBox& box) { return is_sound(box); });
    if (!mask || !are_sound) return not_safe();
    things.mask = std::move(*mask);
    things.signs = header.signs;
    things.is_sure = header.is_sure == 1 && !things.boxes.empty();
    return things;
}

}  // namespace touchline
