#include "app/trace/lines_bytes.h"

#include "app/decode/picture.h"
#include "config/types/fields.h"

#include <cstdint>

namespace touchline {
namespace {

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
    return fits_a_picture(static_cast<std::uint64_t>(size.width),
                          static_cast<std::uint64_t>(size.height));
}

}  // namespace

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
    FieldCheck check;
    Found found;
    found_fields(bytes, found);
    found_fields(check, found);
    const auto chains = bytes.count(chain_bytes);
    for (std::uint32_t i = 0; i < chains && bytes.is_good(); ++i) {
        Chain& chain = found.lines.chains.emplace_back();
        chain_fields(bytes, chain);
        chain_fields(check, chain);
        chain.points.resize(bytes.count(point_bytes));
        for (EdgePoint& point : chain.points) {
            point_fields(bytes, point);
            point_fields(check, point);
        }
    }
    if (!bytes.is_at_end() || !check.is_sound() || !fits(found.lines.picture) ||
        !fits(found.lines.working))
        return failure("the lines that were found before are damaged; open the picture again");
    found.report.size = found.lines.working;
    return found;
}

}  // namespace touchline
