#include "app/trace/frame_bytes.h"

#include "app/decode/picture.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace touchline {
namespace {

struct FrameHeader {
    std::uint32_t format = 0;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t stride_bytes = 0;
};

}  // namespace

std::vector<std::byte> bytes_of(const CameraFrame& frame) {
    const FrameHeader header{static_cast<std::uint32_t>(frame.format),
                             static_cast<std::uint32_t>(frame.size.width),
                             static_cast<std::uint32_t>(frame.size.height),
                             static_cast<std::uint32_t>(frame.stride_bytes)};
    const auto pixels = std::as_bytes(std::span(frame.bytes));
    std::vector<std::byte> bytes(sizeof header + pixels.size());
    std::memcpy(bytes.data(), &header, sizeof header);
    std::ranges::copy(pixels, bytes.begin() + sizeof header);
    return bytes;
}

Result<CameraFrame> frame_of(std::span<const std::byte> bytes) {
    FrameHeader header;
    const bool is_long_enough = bytes.size() >= sizeof header;
    if (is_long_enough) std::memcpy(&header, bytes.data(), sizeof header);
    if (!is_long_enough || header.format > static_cast<std::uint32_t>(PixelFormat::bgr) ||
        !fits_a_picture(header.width, header.height))
        return failure("the camera's picture cannot be used; take another one");
    const auto pixels = bytes.subspan(sizeof header);
    const auto* const first = reinterpret_cast<const std::uint8_t*>(pixels.data());
    return CameraFrame{static_cast<PixelFormat>(header.format),
                       {static_cast<int>(header.width), static_cast<int>(header.height)},
                       header.stride_bytes,
                       {first, first + pixels.size()}};
}

}  // namespace touchline
