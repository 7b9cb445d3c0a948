#include "app/decode/page.h"

#include "app/decode/one_line.h"
#include "config/types/map_bytes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include <zlib.h>

namespace touchline {
namespace {

constexpr std::uint32_t magic = 0x47'50'4c'54;  // "TLPG"
constexpr std::uint8_t layout = 3;
constexpr std::uint8_t refusal_kind = 0;
constexpr std::uint8_t page_kind = 1;
constexpr std::size_t box_bytes = 8;
constexpr std::size_t header_bytes = 32;
constexpr std::size_t crc_at = 28;

static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(WordBox) == box_bytes);

std::uint32_t checksum(const PageHeaderBytes& bytes) {
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
    std::uint32_t magic = touchline::magic;
    std::uint8_t layout = touchline::layout;
    std::uint8_t figures = 0;
    std::uint8_t kind = page_kind;
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

    PageHeaderBytes bytes{};

  private:
    std::size_t at_ = 0;
};

class Reader {
  public:
    explicit Reader(const PageHeaderBytes& bytes) : bytes_(bytes) {}

    template <class Number>
    void number(Number& value) {
        std::memcpy(&value, bytes_.data() + at_, sizeof value);
        at_ += sizeof value;
    }

  private:
    const PageHeaderBytes& bytes_;
    std::size_t at_ = 0;
};

PageHeaderBytes bytes_of(RawHeader header) {
    Writer first;
    fields(first, header);
    header.crc = checksum(first.bytes);
    Writer second;
    fields(second, header);
    return second.bytes;
}

tl::unexpected<Error> no_page() {
    return failure("the file could not be opened safely; choose another one");
}

Result<PageHeader> header_in(const PageHeaderBytes& bytes, std::size_t answer_bytes) {
    RawHeader raw;
    Reader reader(bytes);
    fields(reader, raw);
    const bool is_ours = raw.magic == magic && raw.layout == layout && raw.crc == checksum(bytes) &&
                         (raw.kind == page_kind || raw.kind == refusal_kind);
    const bool is_empty = raw.width == 0 && raw.height == 0;
    const bool is_numbered = raw.number >= 1 && raw.number <= raw.count && raw.count <= max_pages;
    const bool is_reduced = raw.reduction <= 8 && std::has_single_bit(raw.reduction);
    if (!is_ours || !(is_empty || fits_a_picture(raw.width, raw.height)) || !is_numbered ||
        !is_reduced || raw.boxes > max_word_boxes || raw.figures > max_figures)
        return no_page();
    const std::uint64_t pixels = std::uint64_t{raw.width} * raw.height;
    const std::uint64_t boxes = std::uint64_t{raw.boxes} + raw.figures;
    if (header_bytes + 3 * pixels + box_bytes * boxes + raw.map_bytes != answer_bytes)
        return no_page();
    return PageHeader{raw.kind == refusal_kind,
                      raw.width,
                      raw.height,
                      raw.number,
                      raw.count,
                      raw.dpi,
                      raw.reduction,
                      raw.boxes,
                      raw.figures,
                      raw.map_bytes};
}

RawHeader header_of(const Page& page) {
    RawHeader header;
    header.width = static_cast<std::uint32_t>(page.picture.width);
    header.height = static_cast<std::uint32_t>(page.picture.height);
    header.number = static_cast<std::uint16_t>(page.number);
    header.count = static_cast<std::uint16_t>(page.count);
    header.dpi = static_cast<std::uint16_t>(page.dpi);
    header.reduction = static_cast<std::uint8_t>(std::lround(1.0 / page.picture.scale));
    header.boxes = static_cast<std::uint16_t>(page.words.size());
    header.figures = static_cast<std::uint8_t>(page.figures.size());
    return header;
}

/// Fails unless every box is inside the picture and holds a pixel.
Result<std::vector<WordBox>> boxes_in(std::span<const std::byte> bytes, const PageHeader& header) {
    std::vector<WordBox> boxes(std::size_t{header.boxes} + header.figures);
    if (!boxes.empty()) std::memcpy(boxes.data(), bytes.data(), bytes.size());
    for (const WordBox& box : boxes) {
        const bool is_inside = box.left < box.right && box.top < box.bottom &&
                               box.right <= header.width && box.bottom <= header.height;
        if (!is_inside) return no_page();
    }
    return boxes;
}

/// What is spoken and shown of a map is one line each, of a length that can be listened to.
void clean_texts(TactileMap& map) {
    constexpr std::size_t longest_name = 200;
    constexpr std::size_t longest_description = 4000;
    map.title = one_spaced(map.title, longest_name);
    map.description = one_spaced(map.description, longest_description);
    for (Label& label : map.labels) label.text = one_spaced(label.text, longest_name);
    for (Outline& outline : map.outlines) outline.label = one_spaced(outline.label, longest_name);
}

/// What the map's bytes hold: the texts of the figures before its own labels.
TactileMap crossing(const Page& page) {
    TactileMap map = page.told;
    std::vector<Label> texts;
    for (const Figure& figure : page.figures) texts.push_back({figure.text, {}});
    map.labels.insert(map.labels.begin(), texts.begin(), texts.end());
    return map;
}

/// The boxes are those of the words, then those of the figures.
void take_figures(std::vector<WordBox>& boxes, std::size_t count, Page& page) {
    std::vector<Label>& labels = page.told.labels;
    const std::size_t words = boxes.size() - count;
    for (std::size_t i = 0; i < count; ++i)
        page.figures.push_back({boxes[words + i], std::move(labels[i].text)});
    labels.erase(labels.begin(), labels.begin() + static_cast<std::ptrdiff_t>(count));
    boxes.resize(words);
}

TactileMap refusal_of(const std::string& line) {
    TactileMap map;
    map.description = line;
    return map;
}

}  // namespace

Result<std::vector<std::byte>> answer_of(const Result<Page>& page) {
    const auto map = bytes_of(page ? crossing(*page) : refusal_of(page.error().line));
    if (!map) return map;
    RawHeader header = page ? header_of(*page) : RawHeader{.kind = refusal_kind};
    header.map_bytes = static_cast<std::uint32_t>(map->size());
    const PageHeaderBytes first = bytes_of(header);
    std::vector<std::byte> answer(first.begin(), first.end());
    if (page) {
        std::vector<WordBox> all = page->words;
        for (const Figure& figure : page->figures) all.push_back(figure.box);
        answer.reserve(first.size() + page->picture.bgr.size() + box_bytes * all.size() +
                       map->size());
        const auto pixels = std::as_bytes(std::span(page->picture.bgr));
        answer.insert(answer.end(), pixels.begin(), pixels.end());
        const auto boxes = std::as_bytes(std::span(all));
        answer.insert(answer.end(), boxes.begin(), boxes.end());
    }
    answer.insert(answer.end(), map->begin(), map->end());
    return answer;
}

Result<PageHeader> verified(const Untrusted<PageHeaderBytes>& header, std::size_t answer_bytes) {
    return header.verify(
        [answer_bytes](const PageHeaderBytes& bytes) { return header_in(bytes, answer_bytes); });
}

Result<Page> page_of(std::span<const std::byte> answer) {
    if (answer.size() < header_bytes) return no_page();
    PageHeaderBytes first{};
    std::copy_n(answer.begin(), header_bytes, first.begin());
    const auto header = verified(Untrusted(first), answer.size());
    if (!header) return tl::unexpected(header.error());
    const std::size_t boxes_bytes = box_bytes * (std::size_t{header->boxes} + header->figures);
    const auto pixels = answer.subspan(
        header_bytes, answer.size() - header_bytes - boxes_bytes - header->map_bytes);
    auto boxes = boxes_in(answer.subspan(header_bytes + pixels.size(), boxes_bytes), *header);
    auto map = map_of(answer.last(header->map_bytes));
    if (!map || !boxes || map->labels.size() < header->figures) return no_page();
    if (header->is_refusal)
        return failure(map->description.empty() ? "the file cannot be opened"
                                                : one_line(map->description));
    Page page;
    page.picture.width = static_cast<int>(header->width);
    page.picture.height = static_cast<int>(header->height);
    const auto* const first_pixel = reinterpret_cast<const std::uint8_t*>(pixels.data());
    page.picture.bgr.assign(first_pixel, first_pixel + pixels.size());
    page.picture.scale = 1.0 / header->reduction;
    page.told = std::move(*map);
    clean_texts(page.told);
    take_figures(*boxes, header->figures, page);
    page.words = std::move(*boxes);
    page.number = header->number;
    page.count = header->count;
    page.dpi = header->dpi;
    return page;
}

}  // namespace touchline
