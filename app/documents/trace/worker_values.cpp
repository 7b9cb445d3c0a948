#include "app/documents/trace/worker_values.h"

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

template <class Fields, class Grey>
void grey_fields(Fields& f, Grey& picture) {
    f.number(picture.width);
    f.number(picture.height);
}

template <class Fields, class Size>
void size_fields(Fields& f, Size& size) {
    f.number(size.width, 1, max_picture_side_px);
    f.number(size.height, 1, max_picture_side_px);
}

/// All fields except the chains.
template <class Fields, class Lines>
void found_fields(Fields& f, Lines& found) {
    size_fields(f, found.lines.picture);
    size_fields(f, found.lines.working);
    f.finite(found.lines.high);
    f.choice(found.decision.picture_class, PictureClass::text_page);
    f.template text<std::uint32_t>(found.decision.reason);
    f.finite(found.report.noise);
    f.finite(found.report.smoothing_px);
    f.finite(found.report.low);
    f.finite(found.report.high);
    f.flag(found.report.is_grain);
    f.number(found.report.lines_found);
    f.number(found.report.gaps_closed);
    f.number(found.report.junctions);
    f.number(found.report.specks_dropped);
}

/// All fields except the points.
template <class Fields, class Line>
void chain_fields(Fields& f, Line& chain) {
    f.flag(chain.is_closed);
    f.choice(chain.of, LineOf::background);
    f.finite(chain.width_px);
}

template <class Fields, class Point>
void point_fields(Fields& f, Point& point) {
    f.finite(point.at.x);
    f.finite(point.at.y);
    f.finite(point.strength);
    f.finite(point.to_light[0]);
    f.finite(point.to_light[1]);
    f.flag(point.is_fixed);
}

constexpr std::size_t point_bytes = 3 * sizeof(double) + 2 * sizeof(float) + 1;
constexpr std::size_t chain_bytes = 1 + sizeof(LineOf) + sizeof(double) + sizeof(std::uint32_t);

bool fits(cv::Size size) {
    return fits_a_picture(size.width, size.height);
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
    if (!bytes.is_good() || !fits(frame.size) || frame.stride_bytes > all.size())
        return failure("the camera's picture cannot be used; take another one");
    frame.bytes = samples_of(bytes.raw(bytes.left()));
    return frame;
}

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
    const bool is_picture = bytes.is_good() && fits_a_picture(picture.width, picture.height);
    if (!is_picture || bytes.left() != static_cast<std::size_t>(picture.width) *
                                           static_cast<std::size_t>(picture.height))
        return failure("the picture's parts do not fit together");
    picture.grey = samples_of(bytes.raw(bytes.left()));
    return picture;
}

std::vector<std::byte> bytes_of(const Found& found) {
    std::size_t points = 0;
    for (const Chain& chain : found.lines.chains) points += chain.points.size();
    ByteWriter bytes;
    bytes.reserve(chain_bytes * found.lines.chains.size() + point_bytes * points);
    found_fields(bytes, found);
    bytes.count(found.lines.chains.size());
    for (const Chain& chain : found.lines.chains) {
        chain_fields(bytes, chain);
        bytes.count(chain.points.size());
        for (const EdgePoint& point : chain.points) point_fields(bytes, point);
    }
    return bytes.take();
}

Result<Found> found_of(std::span<const std::byte> all) {
    ByteReader bytes(all);
    Found found;
    bool is_sound =
        read_checked(bytes, found, [](auto& f, auto& all_of) { found_fields(f, all_of); });
    const auto chains = bytes.count(chain_bytes);
    for (std::uint32_t i = 0; i < chains && is_sound; ++i) {
        Chain& chain = found.lines.chains.emplace_back();
        is_sound = read_checked(bytes, chain, [](auto& f, auto& line) { chain_fields(f, line); });
        chain.points.resize(bytes.count(point_bytes));
        for (EdgePoint& point : chain.points)
            is_sound = read_checked(bytes, point, [](auto& f, auto& at) { point_fields(f, at); }) &&
                       is_sound;
    }
    if (!is_sound || !bytes.is_at_end() || !fits(found.lines.picture) || !fits(found.lines.working))
        return failure("the lines that were found before are damaged; open the picture again");
    found.report.size = found.lines.working;
    return found;
}

}  // namespace touchline
