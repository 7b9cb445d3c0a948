#include "app/documents/decode/page.h"

#include "app/documents/decode/one_line.h"
#include "config/types/fields.h"
#include "config/types/map_bytes.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

namespace touchline {
namespace decode {
namespace {

constexpr std::uint32_t answer_magic = 0x47'50'4c'54;  // "TLPG"
constexpr std::uint8_t layout = 4;

static_assert(sizeof(WordBox) == 8);

template <class Fields, class Header>
void fields(Fields& f, Header& header) {
    f.number(header.figures, 0, max_figures);
    f.choice(header.kind, AnswerKind::words);
    f.number(header.reduction, 1, 8);
    f.number(header.width);
    f.number(header.height);
    f.number(header.number, 1, max_pages);
    f.number(header.count, 1, max_pages);
    f.number(header.dpi);
    f.number(header.boxes, 0, max_word_boxes);
    f.number(header.map_bytes);
}

tl::unexpected<Error> unsafe() {
    return failure("the file could not be opened safely; choose another one");
}

std::size_t pixel_bytes(const AnswerHeader& header) {
    if (header.kind != AnswerKind::page) return 0;
    return std::size_t{3} * header.width * header.height;
}

std::size_t all_boxes(const AnswerHeader& header) {
    return std::size_t{header.boxes} + header.figures;
}

/// True if the pixels suit the kind: words need them, a refusal has none.
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

/// Nothing unless every field is in its range and the rest is exactly as long as the header says.
std::optional<AnswerHeader> header_in(ByteReader& bytes) {
    if (bytes.number<std::uint32_t>() != answer_magic || bytes.number<std::uint8_t>() != layout)
        return std::nullopt;
    AnswerHeader header;
    const bool is_sound =
        read_checked(bytes, header, [](auto& f, auto& head) { fields(f, head); }) &&
        header.number <= header.count && std::has_single_bit(header.reduction) &&
        has_what_its_kind_has(header) &&
        pixel_bytes(header) + sizeof(WordBox) * all_boxes(header) + header.map_bytes ==
            bytes.left();
    return is_sound ? std::optional(header) : std::nullopt;
}

/// Fails unless every box is inside the picture and holds a pixel.
Result<std::vector<WordBox>> boxes_in(std::span<const std::byte> bytes,
                                      const AnswerHeader& header) {
    std::vector<WordBox> boxes(all_boxes(header));
    if (!boxes.empty()) std::memcpy(boxes.data(), bytes.data(), bytes.size());
    for (const WordBox& box : boxes) {
        const bool is_inside = box.left < box.right && box.top < box.bottom &&
                               box.right <= header.width && box.bottom <= header.height;
        if (!is_inside) return unsafe();
    }
    return boxes;
}

}  // namespace

void clean_texts(TactileMap& map) {
    constexpr std::size_t longest_name = 200;
    constexpr std::size_t longest_description = 4000;
    map.title = one_spaced(map.title, longest_name);
    map.description = one_spaced(map.description, longest_description);
    for (Label& label : map.labels) label.text = one_spaced(label.text, longest_name);
    for (Outline& outline : map.outlines) outline.label = one_spaced(outline.label, longest_name);
}

Result<std::vector<std::byte>> answer_with(AnswerHeader header,
                                           std::span<const std::uint8_t> pixels,
                                           std::span<const WordBox> boxes, const TactileMap& map) {
    const auto map_bytes = bytes_of(map);
    if (!map_bytes) return map_bytes;
    header.boxes = static_cast<std::uint16_t>(boxes.size() - header.figures);
    header.map_bytes = static_cast<std::uint32_t>(map_bytes->size());
    ByteWriter answer;
    answer.number(answer_magic);
    answer.number(layout);
    fields(answer, header);
    answer.reserve(answer.bytes().size() + pixels.size() + boxes.size_bytes() + map_bytes->size());
    answer.raw(std::as_bytes(pixels));
    answer.raw(std::as_bytes(boxes));
    answer.raw(*map_bytes);
    return answer.take();
}

Result<std::vector<std::byte>> refusal(const std::string& line) {
    TactileMap map;
    map.description = line;
    return answer_with({.kind = AnswerKind::refusal}, {}, {}, map);
}

Result<AnswerParts> parts_of(std::span<const std::byte> answer) {
    ByteReader bytes(answer);
    const auto header = header_in(bytes);
    if (!header) return unsafe();
    const auto pixels = bytes.raw(pixel_bytes(*header));
    auto found = boxes_in(bytes.raw(sizeof(WordBox) * all_boxes(*header)), *header);
    auto map = map_of(bytes.raw(header->map_bytes));
    if (!map || !found) return unsafe();
    if (header->kind == AnswerKind::refusal)
        return failure(map->description.empty() ? "the file cannot be opened"
                                                : one_line(map->description));
    clean_texts(*map);
    return AnswerParts{*header, pixels, std::move(*found), std::move(*map)};
}

}  // namespace decode

namespace {

decode::AnswerHeader header_of(const Picture& picture) {
    decode::AnswerHeader header;
    header.width = static_cast<std::uint32_t>(picture.width);
    header.height = static_cast<std::uint32_t>(picture.height);
    header.reduction = static_cast<std::uint8_t>(std::lround(1.0 / picture.scale));
    return header;
}

/// What the map's bytes hold: the texts of the figures, then its own labels.
TactileMap crossing(const Page& page) {
    TactileMap map = page.told;
    std::vector<Label> texts;
    for (const Figure& figure : page.figures) texts.push_back({figure.text, {}});
    map.labels.insert(map.labels.begin(), texts.begin(), texts.end());
    return map;
}

std::vector<WordBox> all_boxes_of(const Page& page) {
    std::vector<WordBox> boxes = page.words;
    for (const Figure& figure : page.figures) boxes.push_back(figure.box);
    return boxes;
}

/// The boxes of the words come first, then those of the figures.
void take_figures(std::vector<WordBox>& boxes, std::size_t count, Page& page) {
    std::vector<Label>& labels = page.told.labels;
    const std::size_t words = boxes.size() - count;
    for (std::size_t i = 0; i < count; ++i)
        page.figures.push_back({boxes[words + i], std::move(labels[i].text)});
    labels.erase(labels.begin(), labels.begin() + static_cast<std::ptrdiff_t>(count));
    boxes.resize(words);
}

}  // namespace

Result<std::vector<std::byte>> answer_of(const Result<Page>& page) {
    if (!page) return decode::refusal(page.error().line);
    decode::AnswerHeader header = header_of(page->picture);
    header.number = static_cast<std::uint16_t>(page->number);
    header.count = static_cast<std::uint16_t>(page->count);
    header.dpi = static_cast<std::uint16_t>(page->dpi);
    header.figures = static_cast<std::uint8_t>(page->figures.size());
    return decode::answer_with(header, page->picture.bgr, all_boxes_of(*page), crossing(*page));
}

Result<std::vector<std::byte>> answer_of(const Picture& picture) {
    return decode::answer_with(header_of(picture), picture.bgr, {}, {});
}

Result<Page> page_of(std::span<const std::byte> answer) {
    auto parts = decode::parts_of(answer);
    if (!parts) return tl::unexpected(parts.error());
    const decode::AnswerHeader& header = parts->header;
    if (header.kind != decode::AnswerKind::page || parts->map.labels.size() < header.figures)
        return failure("the file could not be opened safely; choose another one");
    Page page;
    page.picture.width = static_cast<int>(header.width);
    page.picture.height = static_cast<int>(header.height);
    page.picture.bgr = samples_of(parts->pixels);
    page.picture.scale = 1.0 / header.reduction;
    page.told = std::move(parts->map);
    take_figures(parts->boxes, header.figures, page);
    page.words = std::move(parts->boxes);
    page.number = header.number;
    page.count = header.count;
    page.dpi = header.dpi;
    return page;
}

}  // namespace touchline
