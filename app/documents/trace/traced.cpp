#include "app/documents/trace/traced.h"

#include "app/documents/decode/one_line.h"
#include "app/documents/decode/page.h"
#include "config/types/fields.h"
#include "config/types/map_bytes.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace touchline {
namespace {

struct Header {
    bool is_photo = false;
    std::uint32_t width = 0;  // of the edges; both 0: no edges
    std::uint32_t height = 0;
    std::uint32_t map = 0;  // bytes of each part that follows
    std::uint32_t lines = 0;
};

template <class Fields, class Head>
void header_fields(Fields& f, Head& header) {
    f.flag(header.is_photo);
    f.number(header.width);
    f.number(header.height);
    f.number(header.map);
    f.number(header.lines);
}

constexpr std::uint32_t traced_magic = 0x33545254;  // "TRT3"
constexpr std::size_t longest_sentence = 400;

tl::unexpected<Error> unsafe() {
    return failure("its outlines could not be found safely; choose another picture");
}

/// Nothing if it is no header, or its edges are no picture.
std::optional<Header> header_in(ByteReader& bytes) {
    Header header;
    if (bytes.number<std::uint32_t>() != traced_magic) return std::nullopt;
    const bool is_read =
        read_checked(bytes, header, [](auto& f, auto& head) { header_fields(f, head); });
    const bool has_edges = header.width != 0 || header.height != 0;
    const bool is_sound = is_read && (!has_edges || fits_a_picture(header.width, header.height));
    return is_sound ? std::optional(header) : std::nullopt;
}

/// The report is written into a file that somebody asked for, so it must be lines of text, without
/// control codes for a terminal.
bool is_plain(const std::string& text) {
    return std::ranges::all_of(text, [](char c) {
        const auto code = static_cast<unsigned char>(c);
        return c == '\n' || (code >= 0x20 && code != 0x7f);
    });
}

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

Result<std::vector<std::byte>> bytes_of(const Result<TracedMap>& traced,
                                        std::span<const std::byte> found) {
    static const TracedMap nothing;
    const TracedMap& what = traced ? *traced : nothing;
    const std::string why = traced ? std::string() : traced.error().line;
    const auto outlines = traced ? bytes_of(traced->map) : std::vector<std::byte>();
    if (!outlines) return outlines;
    const Header header{what.is_photo, static_cast<std::uint32_t>(what.edges.width),
                        static_cast<std::uint32_t>(what.edges.height),
                        static_cast<std::uint32_t>(outlines->size()),
                        static_cast<std::uint32_t>(found.size())};
    ByteWriter bytes;
    bytes.number(traced_magic);
    header_fields(bytes, header);
    bytes.text<std::uint32_t>(why);
    bytes.text<std::uint32_t>(what.warning);
    bytes.text<std::uint32_t>(what.report);
    bytes.raw(*outlines);
    bytes.raw(std::as_bytes(std::span(what.edges.grey)));
    bytes.raw(found);
    return bytes.take();
}

Result<Traced> traced_of(std::span<const std::byte> all) {
    ByteReader bytes(all);
    const auto header = header_in(bytes);
    if (!header) return unsafe();
    TracedMap what;
    what.is_photo = header->is_photo;
    std::string why;
    bytes.text<std::uint32_t>(why);
    bytes.text<std::uint32_t>(what.warning);
    bytes.text<std::uint32_t>(what.report);
    const auto map = bytes.raw(header->map);
    const auto grey = bytes.raw(std::size_t{header->width} * header->height);
    (void)bytes.raw(header->lines);
    if (!bytes.is_at_end()) return unsafe();
    why = one_spaced(why, longest_sentence);
    what.warning = one_spaced(what.warning, longest_sentence);
    auto outlines = map_of(map);
    const bool has_lines = header->lines != 0;
    if (!why.empty()) return Traced{failure(why), has_lines};
    if (!outlines || outlines->outlines.empty() || !is_plain(what.report)) return unsafe();
    what.map = std::move(*outlines);
    decode::clean_texts(what.map);
    what.edges = {static_cast<int>(header->width), static_cast<int>(header->height),
                  samples_of(grey)};
    return Traced{std::move(what), has_lines};
}

std::span<const std::byte> lines_in(std::span<const std::byte> all) {
    ByteReader bytes(all);
    const auto header = header_in(bytes);
    return header && header->lines <= bytes.left() ? all.last(header->lines)
                                                   : std::span<const std::byte>();
}

std::vector<std::byte> joined(const ThingsInBytes& things) {
    std::size_t all = things.size() * sizeof(std::uint64_t);
    for (const auto thing : things) all += thing.size();
    ByteWriter bytes;
    bytes.reserve(all);
    for (const auto thing : things) bytes.number(std::uint64_t{thing.size()});
    for (const auto thing : things) bytes.raw(thing);
    return bytes.take();
}

ThingsInBytes parted(std::span<const std::byte> all, std::size_t count) {
    ByteReader bytes(all);
    std::vector<std::uint64_t> sizes(count);
    for (std::uint64_t& size : sizes) bytes.number(size);
    ThingsInBytes things;
    for (const std::uint64_t size : sizes) things.push_back(bytes.raw(size));
    return bytes.is_at_end() ? things : ThingsInBytes();
}

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
