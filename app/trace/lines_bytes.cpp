#include "app/trace/lines_bytes.h"

#include "app/decode/picture.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace touchline {
namespace {

struct LinesHeader {
    std::uint32_t chains = 0;
    std::uint32_t points = 0;  // of all chains
    std::uint32_t reason = 0;  // bytes
    std::int32_t picture_class = 0;
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::int32_t working_width = 0;
    std::int32_t working_height = 0;
    std::int32_t is_grain = 0;
    std::int32_t lines_found = 0;
    std::int32_t gaps_closed = 0;
    std::int32_t junctions = 0;
    std::int32_t specks_dropped = 0;
    std::int32_t none = 0;
    double line_high = 0.0;
    double noise = 0.0;
    double smoothing_px = 0.0;
    double low = 0.0;
    double high = 0.0;
};

struct ChainHead {
    std::uint32_t points = 0;
    std::uint16_t is_closed = 0;
    std::uint16_t of = 0;
    double width_px = 0.0;
};

struct StoredPoint {
    double x = 0.0;
    double y = 0.0;
    double strength = 0.0;
    float light_x = 0.0F;
    float light_y = 0.0F;
    std::uint64_t is_fixed = 0;
};

template <class T>
void append(std::vector<std::byte>& bytes, const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto* const first = reinterpret_cast<const std::byte*>(&value);
    bytes.insert(bytes.end(), first, first + sizeof value);
}

LinesHeader header_of(const Found& found) {
    LinesHeader header;
    header.chains = static_cast<std::uint32_t>(found.lines.chains.size());
    for (const Chain& chain : found.lines.chains)
        header.points += static_cast<std::uint32_t>(chain.points.size());
    header.reason = static_cast<std::uint32_t>(found.decision.reason.size());
    header.picture_class = static_cast<std::int32_t>(found.decision.picture_class);
    header.width = found.lines.picture.width;
    header.height = found.lines.picture.height;
    header.working_width = found.lines.working.width;
    header.working_height = found.lines.working.height;
    header.is_grain = found.report.is_grain ? 1 : 0;
    header.lines_found = found.report.lines_found;
    header.gaps_closed = found.report.gaps_closed;
    header.junctions = found.report.junctions;
    header.specks_dropped = found.report.specks_dropped;
    header.line_high = found.lines.high;
    header.noise = found.report.noise;
    header.smoothing_px = found.report.smoothing_px;
    header.low = found.report.low;
    header.high = found.report.high;
    return header;
}

Found without_chains(const LinesHeader& header) {
    Found found;
    found.lines.working = {header.working_width, header.working_height};
    found.lines.picture = {header.width, header.height};
    found.lines.high = header.line_high;
    found.decision.picture_class = static_cast<PictureClass>(header.picture_class);
    found.report.size = found.lines.working;
    found.report.noise = header.noise;
    found.report.smoothing_px = header.smoothing_px;
    found.report.low = header.low;
    found.report.high = header.high;
    found.report.is_grain = header.is_grain != 0;
    found.report.lines_found = header.lines_found;
    found.report.gaps_closed = header.gaps_closed;
    found.report.junctions = header.junctions;
    found.report.specks_dropped = header.specks_dropped;
    return found;
}

bool are_finite(std::initializer_list<double> numbers) {
    for (const double number : numbers)
        if (!std::isfinite(number)) return false;
    return true;
}

bool is_sound(const LinesHeader& header) {
    const auto is_size = [](std::int32_t width, std::int32_t height) {
        return width > 0 && height > 0 &&
               fits_a_picture(static_cast<std::uint64_t>(width),
                              static_cast<std::uint64_t>(height));
    };
    return header.picture_class >= 0 &&
           header.picture_class <= static_cast<int>(PictureClass::text_page) &&
           is_size(header.width, header.height) &&
           is_size(header.working_width, header.working_height) &&
           are_finite(
               {header.line_high, header.noise, header.smoothing_px, header.low, header.high});
}

/// Takes values off the front; the whole was measured before.
class Reader {
  public:
    explicit Reader(std::span<const std::byte> bytes) : left_(bytes) {}

    template <class T>
    T next() {
        T value;
        std::memcpy(&value, left_.data(), sizeof value);
        left_ = left_.subspan(sizeof value);
        return value;
    }

    std::string text(std::size_t size) {
        std::string text(reinterpret_cast<const char*>(left_.data()), size);
        left_ = left_.subspan(size);
        return text;
    }

  private:
    std::span<const std::byte> left_;
};

tl::unexpected<Error> damaged() {
    return failure("the lines that were found before are damaged; open the picture again");
}

std::size_t size_of(const LinesHeader& header) {
    return sizeof header + header.reason + sizeof(ChainHead) * header.chains +
           sizeof(StoredPoint) * header.points;
}

}  // namespace

std::vector<std::byte> bytes_of(const Found& found) {
    const LinesHeader header = header_of(found);
    std::vector<std::byte> bytes;
    bytes.reserve(size_of(header));
    append(bytes, header);
    for (const char c : found.decision.reason) append(bytes, c);
    for (const Chain& chain : found.lines.chains)
        append(bytes, ChainHead{static_cast<std::uint32_t>(chain.points.size()), chain.is_closed,
                                static_cast<std::uint16_t>(chain.of), chain.width_px});
    for (const Chain& chain : found.lines.chains)
        for (const EdgePoint& point : chain.points)
            append(bytes, StoredPoint{point.at.x, point.at.y, point.strength, point.to_light[0],
                                      point.to_light[1], point.is_fixed});
    return bytes;
}

Result<Found> found_of(std::span<const std::byte> bytes) {
    if (bytes.size() < sizeof(LinesHeader)) return damaged();
    Reader reader(bytes);
    const auto header = reader.next<LinesHeader>();
    if (!is_sound(header) || size_of(header) != bytes.size()) return damaged();
    Found found = without_chains(header);
    found.decision.reason = reader.text(header.reason);
    std::uint64_t points = 0;
    for (std::uint32_t i = 0; i < header.chains; ++i) {
        const auto head = reader.next<ChainHead>();
        points += head.points;
        const bool is_right = points <= header.points &&
                              head.of <= static_cast<std::uint16_t>(LineOf::background) &&
                              are_finite({head.width_px});
        if (!is_right) return damaged();
        Chain chain{{}, head.is_closed != 0, head.width_px, static_cast<LineOf>(head.of)};
        chain.points.resize(head.points);
        found.lines.chains.push_back(std::move(chain));
    }
    if (points != header.points) return damaged();
    for (Chain& chain : found.lines.chains)
        for (EdgePoint& point : chain.points) {
            const auto stored = reader.next<StoredPoint>();
            if (!are_finite({stored.x, stored.y, stored.strength,
                             static_cast<double>(stored.light_x),
                             static_cast<double>(stored.light_y)}))
                return damaged();
            point = {{stored.x, stored.y},
                     stored.strength,
                     stored.is_fixed != 0,
                     {stored.light_x, stored.light_y}};
        }
    return found;
}

}  // namespace touchline
