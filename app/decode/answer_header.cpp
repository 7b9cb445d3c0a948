#include "app/decode/answer_header.h"

#include "app/decode/picture.h"

#include <bit>
#include <cstring>

#include <zlib.h>

namespace touchline {
namespace {

constexpr std::uint32_t answer_magic = 0x47'50'4c'54;  // "TLPG"
constexpr std::uint8_t layout = 3;
constexpr std::size_t crc_at = 28;

static_assert(std::endian::native == std::endian::little);

std::uint32_t checksum(const AnswerHeaderBytes& bytes) {
    const auto* const first = reinterpret_cast<const Bytef*>(bytes.data());
    return static_cast<std::uint32_t>(::crc32(0, first, crc_at));
}

/// The fields in their order, for both directions.
template <class File, class Header>
void fields(File& file, Header& h) {
    file.number(h.magic);
    file.number(h.layout);
    file.number(h.figures);
    file.number(h.kind);
    file.number(h.reduction);
    file.number(h.width);
    file.number(h.height);
    file.number(h.number);
    file.number(h.count);
    file.number(h.dpi);
    file.number(h.boxes);
    file.number(h.map_bytes);
    file.number(h.crc);
}

struct RawHeader {
    std::uint32_t magic = answer_magic;
    std::uint8_t layout = touchline::layout;
    std::uint8_t figures = 0;
    std::uint8_t kind = 0;
    std::uint8_t reduction = 1;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint16_t number = 1;
    std::uint16_t count = 1;
    std::uint16_t dpi = 0;
    std::uint16_t boxes = 0;
    std::uint32_t map_bytes = 0;
    std::uint32_t crc = 0;
};

class Writer {
  public:
    template <class Number>
    void number(const Number& value) {
        std::memcpy(bytes.data() + at_, &value, sizeof value);
        at_ += sizeof value;
    }

    AnswerHeaderBytes bytes{};

  private:
    std::size_t at_ = 0;
};

class Reader {
  public:
    explicit Reader(const AnswerHeaderBytes& bytes) : bytes_(bytes) {}

    template <class Number>
    void number(Number& value) {
        std::memcpy(&value, bytes_.data() + at_, sizeof value);
        at_ += sizeof value;
    }

  private:
    const AnswerHeaderBytes& bytes_;
    std::size_t at_ = 0;
};

RawHeader raw_of(const AnswerHeader& header) {
    RawHeader raw;
    raw.kind = static_cast<std::uint8_t>(header.kind);
    raw.reduction = static_cast<std::uint8_t>(header.reduction);
    raw.width = header.width;
    raw.height = header.height;
    raw.number = static_cast<std::uint16_t>(header.number);
    raw.count = static_cast<std::uint16_t>(header.count);
    raw.dpi = static_cast<std::uint16_t>(header.dpi);
    raw.boxes = header.boxes;
    raw.figures = header.figures;
    raw.map_bytes = header.map_bytes;
    return raw;
}

/// Pixels where words are found in them, none where there is no page.
bool has_what_its_kind_has(const AnswerHeader& header) {
    const bool is_empty = header.width == 0 && header.height == 0;
    const bool is_picture = fits_a_picture(header.width, header.height);
    switch (header.kind) {
        case AnswerKind::refusal:
            return is_empty && all_boxes(header) == 0;
        case AnswerKind::page:
            return is_empty || is_picture;
        case AnswerKind::words:
            return is_picture && header.figures == 0;
    }
    return false;
}

Result<AnswerHeader> header_in(const AnswerHeaderBytes& bytes, std::size_t answer_bytes) {
    RawHeader raw;
    Reader reader(bytes);
    fields(reader, raw);
    const bool is_ours = raw.magic == answer_magic && raw.layout == layout &&
                         raw.crc == checksum(bytes) &&
                         raw.kind <= static_cast<std::uint8_t>(AnswerKind::words);
    const bool is_numbered = raw.number >= 1 && raw.number <= raw.count && raw.count <= max_pages;
    const bool is_reduced = raw.reduction <= 8 && std::has_single_bit(raw.reduction);
    const AnswerHeader header{static_cast<AnswerKind>(raw.kind),
                              raw.width,
                              raw.height,
                              raw.number,
                              raw.count,
                              raw.dpi,
                              raw.reduction,
                              raw.boxes,
                              raw.figures,
                              raw.map_bytes};
    if (!is_ours || !is_numbered || !is_reduced || !has_what_its_kind_has(header) ||
        raw.boxes > max_word_boxes || raw.figures > max_figures ||
        bytes.size() + pixel_bytes(header) + box_bytes * all_boxes(header) + raw.map_bytes !=
            answer_bytes)
        return failure("the file could not be opened safely; choose another one");
    return header;
}

}  // namespace

std::size_t pixel_bytes(const AnswerHeader& header) {
    if (header.kind != AnswerKind::page) return 0;
    return std::size_t{3} * header.width * header.height;
}

AnswerHeaderBytes bytes_of(const AnswerHeader& header) {
    RawHeader raw = raw_of(header);
    Writer first;
    fields(first, raw);
    raw.crc = checksum(first.bytes);
    Writer second;
    fields(second, raw);
    return second.bytes;
}

Result<AnswerHeader> verified(const Untrusted<AnswerHeaderBytes>& header,
                              std::size_t answer_bytes) {
    return header.verify(
        [answer_bytes](const AnswerHeaderBytes& bytes) { return header_in(bytes, answer_bytes); });
}

}  // namespace touchline
