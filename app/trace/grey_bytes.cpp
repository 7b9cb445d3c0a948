#include "app/trace/grey_bytes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace touchline {
namespace {

using Sizes = std::array<std::uint32_t, 2>;

}  // namespace

std::vector<std::byte> bytes_of(const GreyPicture& picture) {
    const Sizes sizes{static_cast<std::uint32_t>(picture.width),
                      static_cast<std::uint32_t>(picture.height)};
    std::vector<std::byte> bytes(sizeof sizes + picture.grey.size());
    std::memcpy(bytes.data(), sizes.data(), sizeof sizes);
    std::ranges::copy(std::as_bytes(std::span(picture.grey)), bytes.begin() + sizeof sizes);
    return bytes;
}

Result<GreyPicture> grey_of(std::span<const std::byte> bytes) {
    Sizes sizes{};
    if (bytes.size() < sizeof sizes) return failure("the picture's parts do not fit together");
    std::memcpy(sizes.data(), bytes.data(), sizeof sizes);
    const auto rest = bytes.subspan(sizeof sizes);
    if (!fits_a_picture(sizes[0], sizes[1]) || rest.size() != std::size_t{sizes[0]} * sizes[1])
        return failure("the picture's parts do not fit together");
    GreyPicture picture{static_cast<int>(sizes[0]), static_cast<int>(sizes[1]), {}};
    const auto* const first = reinterpret_cast<const std::uint8_t*>(rest.data());
    picture.grey.assign(first, first + rest.size());
    return picture;
}

}  // namespace touchline
