#include "app/documents/trace/traced.h"

#include "app/documents/decode/answer_parts.h"
#include "app/documents/decode/one_line.h"
#include "config/types/fields.h"
#include "config/types/map_bytes.h"

#include <algorithm>
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

}  // namespace touchline
