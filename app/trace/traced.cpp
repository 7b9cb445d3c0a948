#include "app/trace/traced.h"

#include "app/decode/answer_parts.h"
#include "app/decode/one_line.h"
#include "config/types/map_bytes.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <utility>

namespace touchline {
namespace {

struct Header {
    std::uint32_t magic = 0;
    std::uint32_t is_photo = 0;
    std::uint32_t refusal = 0;
    std::uint32_t map = 0;
    std::uint32_t warning = 0;
    std::uint32_t report = 0;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t lines = 0;
};

constexpr std::uint32_t traced_magic = 0x32545254;  // "TRT2"
constexpr std::size_t longest_sentence = 400;

tl::unexpected<Error> unsafe() {
    return failure("its outlines could not be found safely; choose another picture");
}

std::uint64_t edge_bytes(const Header& header) {
    return std::uint64_t{header.width} * header.height;
}

/// Nothing where the sizes do not add up to those of the bytes.
std::optional<Header> header_of(std::span<const std::byte> bytes) {
    Header header;
    if (bytes.size() < sizeof header) return std::nullopt;
    std::memcpy(&header, bytes.data(), sizeof header);
    std::uint64_t sum = sizeof header + edge_bytes(header);
    for (const std::uint32_t size :
         {header.refusal, header.map, header.warning, header.report, header.lines})
        sum += size;
    const bool has_edges = header.width != 0 || header.height != 0;
    const bool is_sound = header.magic == traced_magic && header.is_photo <= 1 &&
                          sum == bytes.size() &&
                          (!has_edges || fits_a_picture(header.width, header.height));
    return is_sound ? std::optional(header) : std::nullopt;
}

/// Takes parts off the front, one after the other.
class Parts {
  public:
    explicit Parts(std::span<const std::byte> bytes) : left_(bytes) {}

    std::span<const std::byte> next(std::size_t size) {
        const auto part = left_.first(size);
        left_ = left_.subspan(size);
        return part;
    }

    std::string text(std::size_t size) {
        const auto part = next(size);
        return {reinterpret_cast<const char*>(part.data()), part.size()};
    }

  private:
    std::span<const std::byte> left_;
};

/// It is written into a file that somebody asked for: lines of text, nothing that steers a
/// terminal.
bool is_plain(const std::string& text) {
    return std::ranges::all_of(text, [](char c) {
        const auto code = static_cast<unsigned char>(c);
        return c == '\n' || (code >= 0x20 && code != 0x7f);
    });
}

std::span<const std::byte> bytes_in(const std::string& text) {
    return std::as_bytes(std::span(text));
}

}  // namespace

Result<std::vector<std::byte>> bytes_of(const Result<TracedMap>& traced,
                                        std::span<const std::byte> found) {
    static const TracedMap nothing;
    const TracedMap& what = traced ? *traced : nothing;
    const std::string why = traced ? std::string() : traced.error().line;
    const auto outlines = traced ? bytes_of(traced->map) : std::vector<std::byte>();
    if (!outlines) return outlines;
    const auto size = [](const auto& part) { return static_cast<std::uint32_t>(part.size()); };
    const Header header{traced_magic,
                        what.is_photo ? 1U : 0U,
                        size(why),
                        size(*outlines),
                        size(what.warning),
                        size(what.report),
                        static_cast<std::uint32_t>(what.edges.width),
                        static_cast<std::uint32_t>(what.edges.height),
                        size(found)};
    const std::array<std::span<const std::byte>, 7> parts{std::as_bytes(std::span(&header, 1)),
                                                          bytes_in(why),
                                                          *outlines,
                                                          bytes_in(what.warning),
                                                          bytes_in(what.report),
                                                          std::as_bytes(std::span(what.edges.grey)),
                                                          found};
    std::vector<std::byte> bytes;
    for (const auto part : parts) bytes.insert(bytes.end(), part.begin(), part.end());
    return bytes;
}

Result<Traced> traced_of(std::span<const std::byte> bytes) {
    const auto header = header_of(bytes);
    if (!header) return unsafe();
    Parts parts(bytes.subspan(sizeof *header));
    const std::string why = one_spaced(parts.text(header->refusal), longest_sentence);
    auto outlines = map_of(parts.next(header->map));
    TracedMap what;
    what.is_photo = header->is_photo == 1;
    what.warning = one_spaced(parts.text(header->warning), longest_sentence);
    what.report = parts.text(header->report);
    const auto grey = parts.next(edge_bytes(*header));
    const bool has_lines = header->lines != 0;
    if (!why.empty()) return Traced{failure(why), has_lines};
    if (!outlines || outlines->outlines.empty() || !is_plain(what.report)) return unsafe();
    what.map = std::move(*outlines);
    decode::clean_texts(what.map);
    what.edges = {static_cast<int>(header->width), static_cast<int>(header->height), {}};
    const auto* const first = reinterpret_cast<const std::uint8_t*>(grey.data());
    what.edges.grey.assign(first, first + grey.size());
    return Traced{std::move(what), has_lines};
}

std::span<const std::byte> lines_in(std::span<const std::byte> bytes) {
    const auto header = header_of(bytes);
    return header ? bytes.last(header->lines) : std::span<const std::byte>();
}

}  // namespace touchline
