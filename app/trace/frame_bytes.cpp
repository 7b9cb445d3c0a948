#include "app/trace/frame_bytes.h"

#include "app/decode/picture.h"
#include "config/types/fields.h"

#include <cstdint>

namespace touchline {
namespace {

template <class Fields, class Frame>
void frame_fields(Fields& f, Frame& frame) {
    f.choice(frame.format, PixelFormat::bgr);
    f.number(frame.size.width);
    f.number(frame.size.height);
    f.number(frame.stride_bytes);
}

}  // namespace

std::vector<std::byte> bytes_of(const CameraFrame& frame) {
    ByteWriter bytes;
    frame_fields(bytes, frame);
    bytes.raw(std::as_bytes(std::span(frame.bytes)));
    return bytes.take();
}

Result<CameraFrame> frame_of(std::span<const std::byte> all) {
    ByteReader bytes(all);
    CameraFrame frame;
    frame_fields(bytes, frame);
    const bool is_picture = fits_a_picture(static_cast<std::uint64_t>(frame.size.width),
                                           static_cast<std::uint64_t>(frame.size.height));
    if (!bytes.is_good() || !is_picture || frame.stride_bytes > all.size())
        return failure("the camera's picture cannot be used; take another one");
    const auto pixels = bytes.raw(bytes.left());
    const auto* const first = reinterpret_cast<const std::uint8_t*>(pixels.data());
    frame.bytes.assign(first, first + pixels.size());
    return frame;
}

}  // namespace touchline
